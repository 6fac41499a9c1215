import { lastLevel } from './last-level.ts';

/** Returns the width of a text, pixels. */
export type MeasureText = (text: string) => number;

const ELLIPSIS = '…';

/**
 * Shortens a text to `room` pixels by removing characters at its end. The last level of a topic is kept, and the levels before it
 * are shortened.
 */
export function fitText(text: string, room: number, measure: MeasureText): string {
  if (measure(text) <= room) return text;
  const level = lastLevel(text);
  const end = ELLIPSIS + level;
  if (level !== '' && measure(end) <= room) {
    return cutAtEnd(text.slice(0, text.length - level.length), end, room, measure);
  }
  return cutAtEnd(level === '' ? text : end, ELLIPSIS, room, measure);
}

function cutAtEnd(text: string, end: string, room: number, measure: MeasureText): string {
  const characters = [...text];
  const shown = (kept: number): string => characters.slice(0, kept).join('') + end;
  let [fits, tooMany] = [0, characters.length];
  while (tooMany - fits > 1) {
    const middle = (fits + tooMany) >> 1;
    if (measure(shown(middle)) <= room) fits = middle;
    else tooMany = middle;
  }
  return shown(fits);
}
