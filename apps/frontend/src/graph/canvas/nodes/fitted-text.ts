/** How wide a text is, pixels. */
export type MeasureText = (text: string) => number;

const ELLIPSIS = '…';

/**
 * A text as it fits into `room` pixels: whole, or its beginning and its end, which tells names apart
 * that begin alike.
 */
export function fitText(text: string, room: number, measure: MeasureText): string {
  if (measure(text) <= room) return text;
  const characters = [...text];
  let [fits, tooMany] = [0, characters.length];
  while (tooMany - fits > 1) {
    const middle = (fits + tooMany) >> 1;
    if (measure(withoutMiddle(characters, middle)) <= room) fits = middle;
    else tooMany = middle;
  }
  return withoutMiddle(characters, fits);
}

function withoutMiddle(characters: readonly string[], kept: number): string {
  const atEnd = kept >> 1;
  const start = characters.slice(0, kept - atEnd);
  return [...start, ELLIPSIS, ...characters.slice(characters.length - atEnd)].join('');
}
