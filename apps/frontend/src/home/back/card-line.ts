import { linePath } from '../../ui/charts/line-path.ts';

/** Most lines of a picture; more cannot be distinguished. */
export const MAX_LINES = 3;

/** Area of the lines, and its distance from the edges: units of the drawing. */
const AREA = { left: 24, top: 68, width: 328, height: 108 };

/** Returns lines of equal scale through the values, oldest first; none for fewer than two. */
export function cardLines(values: readonly (readonly number[])[], most: number): string[] {
  if (values.length < 2) return [];
  const known = values.flat().filter((value) => Number.isFinite(value));
  const low = Math.min(...known);
  const span = Math.max(...known) - low;
  const yOf = (value: number): number =>
    span === 0 ? AREA.height / 2 : AREA.height * (1 - (value - low) / span);
  const first = most - values.length;
  return (values[0] ?? []).map((_, line) =>
    linePath(
      values.map((numbers, index) => {
        const value = numbers[line] ?? Number.NaN;
        return {
          x: AREA.left + ((first + index) / (most - 1)) * AREA.width,
          y: Number.isFinite(value) ? AREA.top + yOf(value) : undefined,
        };
      }),
    ),
  );
}
