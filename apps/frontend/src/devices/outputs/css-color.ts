import type { Color } from '@ubii/proto';

/** A colour that came over a topic, parts from 0 to 1, as style sheets take it. */
export function cssColorOf({ r, g, b, a }: Color): string {
  const byte = (value: number): number => Math.round(Math.min(1, Math.max(0, value)) * 255);
  return `rgb(${byte(r)} ${byte(g)} ${byte(b)} / ${Math.min(1, a)})`;
}
