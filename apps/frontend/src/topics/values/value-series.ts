import type { DataFormat, DataFormatValues } from '@ubii/proto';

/** The numbers of a value as series over time. */
export interface ValueSeries {
  /** Names of the series, in order. */
  readonly names: readonly string[];
  /** Paths of the numbers in the value: `position.x`; empty for a value that is a number itself. */
  readonly paths: readonly string[];
  /** Returns the number of each series; NaN without one. */
  read(value: never): readonly number[];
}

function series<F extends DataFormat>(
  names: readonly string[],
  read: (value: DataFormatValues[F]) => readonly number[],
  paths: readonly string[] = names,
): ValueSeries {
  return { names, paths, read };
}

const scalar = series<'double'>(['value'], (value) => [value], ['']);
const quaternion = series<'quaternion'>(['x', 'y', 'z', 'w'], ({ x, y, z, w }) => [x, y, z, w]);

const SERIES: { readonly [F in DataFormat]?: ValueSeries } = {
  double: scalar,
  float: scalar,
  int32: scalar,
  bool: series<'bool'>(['value'], (value) => [value ? 1 : 0], ['']),
  vector2: series<'vector2'>(['x', 'y'], ({ x, y }) => [x, y]),
  vector3: series<'vector3'>(['x', 'y', 'z'], ({ x, y, z }) => [x, y, z]),
  vector4: series<'vector4'>(['x', 'y', 'z', 'w'], ({ x, y, z, w }) => [x, y, z, w]),
  color: series<'color'>(['r', 'g', 'b', 'a'], ({ r, g, b, a }) => [r, g, b, a]),
  quaternion,
  quaternionList: quaternion,
  pose2D: series<'pose2D'>(
    ['x', 'y', 'angle'],
    ({ position, angle: turn }) => [
      position?.x ?? Number.NaN,
      position?.y ?? Number.NaN,
      turn ?? Number.NaN,
    ],
    ['position.x', 'position.y', 'angle'],
  ),
  pose3D: series<'pose3D'>(
    ['x', 'y', 'z'],
    ({ position }) => [
      position?.x ?? Number.NaN,
      position?.y ?? Number.NaN,
      position?.z ?? Number.NaN,
    ],
    ['position.x', 'position.y', 'position.z'],
  ),
};

/** Returns the series of a data format; `undefined` for formats that are not numeric. */
export function seriesOf(format: DataFormat): ValueSeries | undefined {
  return SERIES[format];
}

/** Returns the numbers for a sparkline; empty when the value has none. */
export function sparkNumbers(format: DataFormat, value: unknown): readonly number[] {
  if (LISTS.has(format)) return (value as { elements: readonly number[] }).elements.slice(0, 1);
  return SERIES[format]?.read(value as never) ?? [];
}

/** List formats, represented by their first number. */
const LISTS: ReadonlySet<DataFormat> = new Set<DataFormat>([
  'doubleList',
  'floatList',
  'int32List',
]);
