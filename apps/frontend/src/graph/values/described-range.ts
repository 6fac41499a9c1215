/** Range of a numeric parameter. */
export interface NumberRange {
  readonly min: number;
  readonly max: number;
}

/** Numbers can have a space between thousands, as in `16 384`. */
const RANGE =
  /(?<![\w.])([−-]?(?:\d{1,3}(?:[ \u00a0\u202f]\d{3})+|\d+(?:\.\d+)?)) to ([−-]?(?:\d{1,3}(?:[ \u00a0\u202f]\d{3})+|\d+(?:\.\d+)?))(?![\d.]*\d)/;

const read = (text: string): number =>
  Number(text.replace('−', '-').replace(/[ \u00a0\u202f]/g, ''));

/**
 * Parses the range in the description of an input, such as `Left edge, 0 to 1 of the width.`; undefined without one.
 */
export function describedRange(description: string): NumberRange | undefined {
  const [, from, to] = RANGE.exec(description) ?? [];
  if (from === undefined || to === undefined) return undefined;
  const range = { min: read(from), max: read(to) };
  return range.min < range.max ? range : undefined;
}

/** Step of a slider with at least a hundred positions; integers for wide ranges. */
export function stepIn({ min, max }: NumberRange): number {
  const span = max - min;
  if (span <= 2) return 0.01;
  return span <= 20 ? 0.1 : 1;
}
