import type { DataFormat, DataFormatValues } from '@ubii/proto';

/** The numbers of a value that can be drawn over time. */
export interface ValueSeries {
  /** One for each line, in their order. */
  readonly names: readonly string[];
  /** Where the numbers stand in the value: `position.x`; empty for a value that is a number itself. */
  readonly paths: readonly string[];
  /** The number of each line; NaN where there is none. */
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

/** How a data format is drawn over time; `undefined` for those that are not numbers. */
export function seriesOf(format: DataFormat): ValueSeries | undefined {
  return SERIES[format];
}

/** The numbers a sparkline is made of; none when the value has no numbers. */
export function sparkNumbers(format: DataFormat, value: unknown): readonly number[] {
  if (LISTS.has(format)) return (value as { elements: readonly number[] }).elements.slice(0, 1);
  return SERIES[format]?.read(value as never) ?? [];
}

/** Lists of which the first number stands for all. */
const LISTS: ReadonlySet<DataFormat> = new Set<DataFormat>([
  'doubleList',
  'floatList',
  'int32List',
]);
