import type { Color } from '@ubii/proto';

/** Converts a colour of a topic, with parts from 0 to 1, to CSS. It is data, not a colour of the design. */
export function cssColorOf({ r, g, b, a }: Color): string {
  return `color(srgb ${r} ${g} ${b} / ${a})`;
}
