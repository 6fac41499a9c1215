/**
 * Places flags of markers side by side where they would lie on each other, each as near to its moment as the others let it.
 *
 * @param at pixels from the left edge, ascending
 * @returns left edges of the flags, pixels; where there are more flags than places, they lie on each other
 */
export function placeFlags(
  at: readonly number[],
  flagPx: number,
  widthPx: number,
): readonly number[] {
  if (at.length * flagPx > widthPx) return at;
  const left: number[] = [];
  for (const px of at) left.push(Math.max(px, (left.at(-1) ?? -Infinity) + flagPx));
  return left.map((px, index) => Math.min(px, widthPx - flagPx * (left.length - index)));
}
