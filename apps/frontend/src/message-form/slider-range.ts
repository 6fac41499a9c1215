/** How far a slider reaches to both sides, so that a value has its place on it: 1, 10, 100 … */
export function sliderBound(value: number, isInteger: boolean): number {
  const least = isInteger ? 10 : 1;
  const size = Math.abs(value);
  if (!(size > least)) return least;
  return 10 ** Math.ceil(Math.log10(Math.min(size, 1e15)) - 1e-9);
}

/** Numbers of which the schema says that they go from 0 to 1. */
const UNIT_MEMBERS = /(^|\.)(color\.[rgba]|force)$|Color\.[rgba]$/;
export const isUnitMember = (path: string): boolean => UNIT_MEMBERS.test(path);

/** Sizes of pictures: whole numbers from 0, not from a range to both sides of it. */
const SIZE_MEMBERS = /(^|\.)image2D(List\.elements\[\d+\])?\.(width|height)$/;
export const isSizeMember = (path: string): boolean => SIZE_MEMBERS.test(path);
