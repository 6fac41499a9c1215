import { type MarkerDictionary, markerCells, markerName } from '@ubii/vision/markers';
import { inkOfCells, MARGIN, type PaperName, type Sheet, usableArea } from './paper.ts';

export interface MarkerPrint {
  readonly paper: PaperName;
  readonly dictionary: MarkerDictionary;
  /** First and last id, both printed. */
  readonly from: number;
  readonly to: number;
  /** Side length of a marker including its black border, millimetres. */
  readonly sizeMm: number;
  /** White margin around each marker, millimetres. */
  readonly borderMm: number;
  readonly hasLabels: boolean;
  readonly hasCuts: boolean;
}

/** Height of a label below a marker, millimetres. */
const LABEL = 5;
export const MAX_PRINTED = 600;

/** Returns why markers cannot be printed, one sentence. */
export function markerPrintProblem(print: MarkerPrint): string | undefined {
  const { dictionary, from, to, sizeMm, borderMm, paper, hasLabels } = print;
  const last = dictionary.count - 1;
  const isId = (id: number): boolean => Number.isInteger(id) && id >= 0 && id <= last;
  if (!isId(from) || !isId(to) || from > to) {
    return `Enter ids from 0 to ${last}, the lower one first.`;
  }
  if (to - from + 1 > MAX_PRINTED) return `At most ${MAX_PRINTED} markers can be printed at once.`;
  if (!(sizeMm >= 5)) return 'The minimum size of a marker is 5 mm.';
  const cell = sizeMm / (dictionary.cells + 2);
  if (!(borderMm >= cell)) {
    return `The white border has at least the width of a cell, ${cell.toFixed(1)} mm, or cameras miss the marker.`;
  }
  const { width, height } = usableArea(paper);
  const most = Math.min(width, height - (hasLabels ? LABEL : 0)) - 2 * borderMm;
  if (sizeMm > most) {
    return `On ${paper} the maximum size of a marker with this border is ${Math.floor(most)} mm.`;
  }
  return undefined;
}

/** Returns the sheets of a valid print: rows from the top left, as many as fit. */
export function markerSheets(print: MarkerPrint): readonly Sheet[] {
  const { paper, dictionary, from, to, sizeMm, borderMm, hasLabels, hasCuts } = print;
  const area = usableArea(paper);
  const width = sizeMm + 2 * borderMm;
  const height = width + (hasLabels ? LABEL : 0);
  const columns = Math.floor(area.width / width + 1e-6);
  const rows = Math.floor(area.height / height + 1e-6);
  const left = MARGIN + (area.width - columns * width) / 2;
  const ids = Array.from({ length: to - from + 1 }, (_, index) => from + index);
  const sheets: Sheet[] = [];
  for (let start = 0; start < ids.length; start += columns * rows) {
    const tiles = ids.slice(start, start + columns * rows).map((id, index) => ({
      id,
      x: left + (index % columns) * width,
      y: MARGIN + Math.floor(index / columns) * height,
    }));
    const cell = sizeMm / (dictionary.cells + 2);
    sheets.push({
      paper,
      ink: tiles
        .map(({ id, x, y }) =>
          inkOfCells(markerCells(dictionary, id), x + borderMm, y + borderMm, cell),
        )
        .join(''),
      labels: hasLabels
        ? tiles.map(({ id, x, y }) => ({
            x: x + width / 2,
            y: y + width + LABEL - 2,
            text: `${markerName(dictionary.name, id)} · ${sizeMm} mm`,
          }))
        : [],
      cuts: hasCuts
        ? tiles.map(({ x, y }) => `M${x} ${y}h${width}v${height}h${-width}z`).join('')
        : '',
    });
  }
  return sheets;
}
