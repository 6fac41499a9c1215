// For tsconfig.core.json, which knows no DOM: the codec uses TextDecoder, which every JavaScript
// platform has, but which TypeScript declares only together with the whole DOM.
declare class TextDecoder {
  constructor(label?: string, options?: { fatal?: boolean; ignoreBOM?: boolean });
  decode(input?: Uint8Array): string;
}
