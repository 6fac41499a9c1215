import { TouchEventType, type DataFormat, type TopicRecord } from '@ubii/proto';
import { formatFixed, formatImage } from '../../values/format-value.ts';
import { reachOf } from '../../values/reach.ts';

/** Value as a table. Numbers are right-aligned, other texts left-aligned. */
export interface ValueTable {
  readonly columns: readonly { readonly name: string; readonly isNumber: boolean }[];
  readonly rows: readonly (readonly string[])[];
  /** Number of rows of the value; more than `rows` when not all are shown. */
  readonly count: number;
  /** Header of the index column: `row 0` of a matrix, or the index in a list. */
  readonly head: string;
}

export const MAX_ROWS = 500;

const numbers = (...names: string[]) => names.map((name) => ({ name, isNumber: true }));
const text = (name: string) => ({ name, isNumber: false });
type Cell = string | number | undefined;

function list<T>(
  elements: readonly T[],
  columns: ValueTable['columns'],
  read: (element: T) => readonly Cell[],
): ValueTable {
  const cells = elements.slice(0, MAX_ROWS).map(read);
  return {
    columns,
    rows: writeColumns(cells, (column) => cells.map((row) => row[column])),
    count: elements.length,
    head: '#',
  };
}

/** Formats cells; the numbers of a column alike. */
function writeColumns(
  rows: readonly (readonly Cell[])[],
  cellsOf: (column: number) => readonly Cell[],
): readonly (readonly string[])[] {
  const reaches = (rows[0] ?? []).map((_cell, column) =>
    reachOf(cellsOf(column).filter((cell) => typeof cell === 'number')),
  );
  return rows.map((row) =>
    row.map((cell, column) =>
      typeof cell === 'number' ? formatFixed(cell, 3, reaches[column]) : (cell ?? ''),
    ),
  );
}

function matrix(rows: readonly (readonly number[])[]): ValueTable {
  return {
    columns: numbers(...rows[0]!.map((_part, column) => String(column))),
    rows: writeColumns(rows, () => rows.flat()),
    count: rows.length,
    head: 'row',
  };
}

/** Converts lists and matrices to tables; undefined for single values. */
export function valueTable({ format, value }: TopicRecord): ValueTable | undefined {
  switch (format) {
    case 'matrix3x2':
      return matrix([
        [value.m00, value.m01],
        [value.m10, value.m11],
        [value.m20, value.m21],
      ]);
    case 'matrix4x4':
      return matrix([
        [value.m00, value.m01, value.m02, value.m03],
        [value.m10, value.m11, value.m12, value.m13],
        [value.m20, value.m21, value.m22, value.m23],
        [value.m30, value.m31, value.m32, value.m33],
      ]);
    case 'doubleList':
    case 'floatList':
      return list(value.elements, numbers('value'), (one) => [one]);
    case 'int32List':
      return list(value.elements, numbers('value'), (one) => [formatFixed(one, 0)]);
    case 'boolList':
      return list(value.elements, [text('value')], (one) => [String(one)]);
    case 'stringList':
      return list(value.elements, [text('value')], (one) => [one]);
    case 'vector2List':
      return list(value.elements, numbers('x', 'y'), ({ x, y }) => [x, y]);
    case 'vector3List':
      return list(value.elements, numbers('x', 'y', 'z'), ({ x, y, z }) => [x, y, z]);
    case 'vector4List':
      return list(value.elements, numbers('x', 'y', 'z', 'w'), ({ x, y, z, w }) => [x, y, z, w]);
    case 'object2DList':
      return list(
        value.elements,
        [text('id'), ...numbers('x', 'y', 'width', 'height')],
        ({ id, pose, size }) => [id, pose?.position?.x, pose?.position?.y, size?.x, size?.y],
      );
    case 'object3DList':
      return list(
        value.elements,
        [text('id'), ...numbers('x', 'y', 'z', 'size x', 'size y', 'size z')],
        ({ id, pose, size }) => {
          const at = pose?.position;
          return [id, at?.x, at?.y, at?.z, size?.x, size?.y, size?.z];
        },
      );
    case 'touchEventList':
      return list(
        value.elements,
        [text('id'), text('type'), ...numbers('x', 'y', 'force')],
        ({ id, type, position, force }) => [
          id,
          TOUCHES[type] ?? String(type),
          position?.x,
          position?.y,
          force,
        ],
      );
    case 'image2DList':
      return list(value.elements, [text('picture')], (image) => [formatImage(image)]);
    default:
      return undefined;
  }
}

const TOUCHES: Readonly<Record<number, string>> = {
  [TouchEventType.TOUCH_START]: 'start',
  [TouchEventType.TOUCH_MOVE]: 'move',
  [TouchEventType.TOUCH_END]: 'end',
};

export const TABLE_FORMATS: ReadonlySet<string> = new Set<DataFormat>([
  'matrix3x2',
  'matrix4x4',
  'doubleList',
  'floatList',
  'int32List',
  'boolList',
  'stringList',
  'vector2List',
  'vector3List',
  'vector4List',
  'object2DList',
  'object3DList',
  'touchEventList',
  'image2DList',
]);
