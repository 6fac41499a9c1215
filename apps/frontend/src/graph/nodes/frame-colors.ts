/** Colours of frames, by the words people see; each is drawn with the tokens of a family. */
export const FRAME_COLORS: Readonly<Record<string, string>> = {
  teal: 'number',
  blue: 'vector',
  violet: 'rotation',
  rose: 'event',
  sand: 'text',
  green: 'image',
  orange: 'objects',
  plum: 'pose',
};

/** The tokens of a colour: of its edge and title, and of its ground. */
export function frameTokens(color: string): { edge: string; ground: string } | undefined {
  const family = FRAME_COLORS[color];
  if (family === undefined) return undefined;
  return { edge: `var(--family-${family})`, ground: `var(--family-${family}-tint)` };
}
