/** Colours of frames by display name; each uses the style tokens of a data format family. */
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

/** Style tokens of a colour: for border and title, and for the background. */
export function frameTokens(color: string): { edge: string; ground: string } | undefined {
  const family = FRAME_COLORS[color];
  if (family === undefined) return undefined;
  return { edge: `var(--family-${family})`, ground: `var(--family-${family}-tint)` };
}
