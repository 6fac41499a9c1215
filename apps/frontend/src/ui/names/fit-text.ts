/** Returns the width of a text, pixels. */
export type MeasureText = (text: string) => number;

const ELLIPSIS = '…';

/**
 * Shortens a text to `room` pixels: to its beginning and end, which distinguish names with the same beginning. If that
 * would remove the distinguishing part, to its beginning and that part.
 * @param distinct index at which it differs from similar names, see `distinctAt`
 */
export function fitText(
  text: string,
  room: number,
  measure: MeasureText,
  distinct?: number,
): string {
  if (measure(text) <= room) return text;
  const characters = [...text];
  let [fits, tooMany] = [0, characters.length];
  while (tooMany - fits > 1) {
    const middle = (fits + tooMany) >> 1;
    if (measure(withoutMiddle(characters, middle)) <= room) fits = middle;
    else tooMany = middle;
  }
  const isCut =
    distinct !== undefined &&
    distinct >= fits - (fits >> 1) &&
    distinct < text.length - (fits >> 1);
  return (
    (isCut ? aroundDistinct(text, distinct, room, measure) : undefined) ??
    withoutMiddle(characters, fits)
  );
}

/** Beginnings of words, so that the kept part is readable. */
const WORD_START = /(?<=[-_ ./])[^-_ ./]/g;
/** Number of characters kept from the beginning. */
const START = 3;

/** Returns the beginning, and as much as fits from the word with the difference; undefined when that is too little. */
function aroundDistinct(
  text: string,
  distinct: number,
  room: number,
  measure: MeasureText,
): string | undefined {
  const words = [...text.matchAll(WORD_START)].map(({ index }) => index);
  const from = words.findLast((index) => index <= distinct) ?? distinct;
  if (from <= START) return undefined;
  for (const start of [text.slice(0, START), '']) {
    for (const begin of [from, distinct]) {
      for (let end = text.length; end > distinct; end -= 1) {
        const cut = end < text.length ? ELLIPSIS : '';
        const shown = `${start}${ELLIPSIS}${text.slice(begin, end)}${cut}`;
        if (measure(shown) <= room) return shown;
      }
    }
  }
  return undefined;
}

function withoutMiddle(characters: readonly string[], kept: number): string {
  const atEnd = kept >> 1;
  const start = characters.slice(0, kept - atEnd);
  return [...start, ELLIPSIS, ...characters.slice(characters.length - atEnd)].join('');
}
