/** The numbers that a parameter accepts. */
export interface NumberRange {
  readonly min: number;
  readonly max: number;
}

/** Thousands are apart, as in `16 384`. */
const RANGE =
  /(?<![\w.])([−-]?(?:\d{1,3}(?:[ \u00a0\u202f]\d{3})+|\d+(?:\.\d+)?)) to ([−-]?(?:\d{1,3}(?:[ \u00a0\u202f]\d{3})+|\d+(?:\.\d+)?))(?![\d.]*\d)/;

const read = (text: string): number =>
  Number(text.replace('−', '-').replace(/[ \u00a0\u202f]/g, ''));

/** Reads the range out of the description of an input, such as `Left edge, 0 to 1 of the width.`; undefined without one. */
export function describedRange(description: string): NumberRange | undefined {
  const [, from, to] = RANGE.exec(description) ?? [];
  if (from === undefined || to === undefined) return undefined;
  const range = { min: read(from), max: read(to) };
  return range.min < range.max ? range : undefined;
}

/** The step of a slider: a hundred and more positions, whole numbers where the range is wide. */
export function stepIn({ min, max }: NumberRange): number {
  const span = max - min;
  if (span <= 2) return 0.01;
  return span <= 20 ? 0.1 : 1;
}
