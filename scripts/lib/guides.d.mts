/** A step of a guide: a file that it creates, a change of a file, or commands. */
export type GuideStep =
  | { readonly kind: 'create'; readonly path: string; readonly content: string }
  | { readonly kind: 'change'; readonly path: string; readonly hunks: readonly unknown[] }
  | { readonly kind: 'run'; readonly commands: readonly string[] };

/**
 * Reads the steps of a guide.
 * @throws Error when a block of code names no file
 */
export function readGuide(text: string): GuideStep[];
