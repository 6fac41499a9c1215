/** Returns a symmetric range of a slider that contains the value: 1, 10, 100 … */
export function sliderBound(value: number, isInteger: boolean): number {
  const least = isInteger ? 10 : 1;
  const size = Math.abs(value);
  if (!(size > least)) return least;
  return 10 ** Math.ceil(Math.log10(Math.min(size, 1e15)) - 1e-9);
}

/** Members that, by the schema, range from 0 to 1. */
const UNIT_MEMBERS = /(^|\.)(color\.[rgba]|force)$|Color\.[rgba]$/;
export const isUnitMember = (path: string): boolean => UNIT_MEMBERS.test(path);

/** Sizes of pictures: integers from 0, instead of a symmetric range. */
const SIZE_MEMBERS = /(^|\.)image2D(List\.elements\[\d+\])?\.(width|height)$/;
export const isSizeMember = (path: string): boolean => SIZE_MEMBERS.test(path);
