import type { MarkerDictionary } from './dictionaries.ts';
import { MARKER_DRAWINGS } from './generated/marker-drawings.ts';

/**
 * Cells of a marker: rows from the top, true for a black cell. The black border of one cell is
 * part of it, so that there are `cells + 2` in a row.
 *
 * @throws RangeError when the dictionary has no such marker
 */
export function markerCells(dictionary: MarkerDictionary, id: number): readonly boolean[][] {
  const { name, count, cells, drawings } = dictionary;
  if (!Number.isInteger(id) || id < 0 || id >= count) {
    throw new RangeError(`${name} has no marker ${id}. Its ids are 0 to ${count - 1}.`);
  }
  const digits = Math.ceil((cells * cells) / 4);
  const code = MARKER_DRAWINGS[drawings]!.slice(id * digits, (id + 1) * digits);
  const bits = [...code].flatMap((digit) =>
    [8, 4, 2, 1].map((weight) => (Number.parseInt(digit, 16) & weight) !== 0),
  );
  const side = cells + 2;
  return Array.from({ length: side }, (_, row) =>
    Array.from({ length: side }, (__, column) => {
      const isBorder = row === 0 || column === 0 || row === side - 1 || column === side - 1;
      return isBorder || bits[(row - 1) * cells + column - 1]!;
    }),
  );
}
