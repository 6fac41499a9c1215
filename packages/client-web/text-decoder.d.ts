// Only for tsconfig.core.json. The codec uses TextDecoder, which is part of every JavaScript platform
// but declared by TypeScript only together with the whole DOM.
declare class TextDecoder {
  constructor(label?: string, options?: { fatal?: boolean; ignoreBOM?: boolean });
  decode(input?: Uint8Array): string;
}
