import { MARKER_DRAWINGS } from './generated/marker-drawings.ts';

/** A family of markers. */
export interface MarkerDictionary {
  /** Name in ids of markers, such as `aruco_4x4_50`. */
  readonly name: string;
  /** As people read it. */
  readonly label: string;
  /** Cells of a side, without the black border of one cell. */
  readonly cells: number;
  /** Markers; their ids are 0 to count - 1. */
  readonly count: number;
  /** The dictionary with the same first markers whose drawings are stored. */
  readonly drawings: string;
  /** Its number in OpenCV (`PredefinedDictionaryType`). */
  readonly opencv: number;
}

const aruco = (cells: number, count: number, opencv: number): MarkerDictionary => ({
  name: `aruco_${cells}x${cells}_${count}`,
  label: `ArUco ${cells} × ${cells}, ${count} markers`,
  cells,
  count,
  drawings: `aruco_${cells}x${cells}_250`,
  opencv,
});

const apriltag = (family: string, cells: number, count: number, opencv: number) => ({
  name: `apriltag_${family}`,
  label: `AprilTag ${family}, ${count} markers`,
  cells,
  count,
  drawings: `apriltag_${family}`,
  opencv,
});

/**
 * Dictionaries that can be looked for and printed.
 *
 * Source of the numbers: OpenCV 4.12, `modules/objdetect/include/opencv2/objdetect/aruco_dictionary.hpp`.
 */
export const MARKER_DICTIONARIES: readonly MarkerDictionary[] = [
  aruco(4, 50, 0),
  aruco(4, 100, 1),
  aruco(4, 250, 2),
  aruco(5, 50, 4),
  aruco(5, 100, 5),
  aruco(5, 250, 6),
  aruco(6, 50, 8),
  aruco(6, 100, 9),
  aruco(6, 250, 10),
  apriltag('16h5', 4, 30, 17),
  apriltag('25h9', 5, 35, 18),
  apriltag('36h11', 6, 587, 20),
];

export const DEFAULT_DICTIONARY = 'aruco_4x4_50';

/** @throws RangeError that names the dictionaries there are */
export function markerDictionary(name: string): MarkerDictionary {
  const found = MARKER_DICTIONARIES.find((one) => one.name === name);
  if (found === undefined) {
    const names = MARKER_DICTIONARIES.map((one) => one.name).join(', ');
    throw new RangeError(`There is no dictionary "${name}". Use one of: ${names}.`);
  }
  return found;
}

/** The name of a marker: its dictionary and its id in it, such as `aruco_4x4_50:7`. */
export function markerName(dictionary: string, id: number): string {
  return `${dictionary}:${id}`;
}

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
