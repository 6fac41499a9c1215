import type { Color } from '@ubii/proto';

/** A colour that came over a topic, parts from 0 to 1, as style sheets take it: data, not a colour of the page. */
export function cssColorOf({ r, g, b, a }: Color): string {
  return `color(srgb ${r} ${g} ${b} / ${a})`;
}
