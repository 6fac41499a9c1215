import type { DataFormat, DataFormatValues } from '@ubii/proto';

/** The numbers of a value that can be drawn over time. */
export interface ValueSeries {
  /** One for each line, in their order. */
  readonly names: readonly string[];
  /** The number of each line; NaN where there is none. */
  read(value: never): readonly number[];
  /** The one number that stands for the value where there is room for a single line. */
  summary(numbers: readonly number[]): number;
}

const first = (numbers: readonly number[]): number => numbers[0] ?? Number.NaN;
const length = (numbers: readonly number[]): number => Math.hypot(...numbers);
/** Degrees of a rotation given as x, y, z, w: twice the arc cosine of w. */
const angle = ([, , , w = 1]: readonly number[]): number =>
  (2 * Math.acos(Math.min(1, Math.abs(w))) * 180) / Math.PI;

function series<F extends DataFormat>(
  names: readonly string[],
  read: (value: DataFormatValues[F]) => readonly number[],
  summary: (numbers: readonly number[]) => number = first,
): ValueSeries {
  return { names, read, summary };
}

const scalar = series<'double'>(['value'], (value) => [value]);
const quaternion = series<'quaternion'>(
  ['x', 'y', 'z', 'w'],
  ({ x, y, z, w }) => [x, y, z, w],
  angle,
);

const SERIES: { readonly [F in DataFormat]?: ValueSeries } = {
  double: scalar,
  float: scalar,
  int32: scalar,
  bool: series<'bool'>(['value'], (value) => [value ? 1 : 0]),
  vector2: series<'vector2'>(['x', 'y'], ({ x, y }) => [x, y], length),
  vector3: series<'vector3'>(['x', 'y', 'z'], ({ x, y, z }) => [x, y, z], length),
  vector4: series<'vector4'>(['x', 'y', 'z', 'w'], ({ x, y, z, w }) => [x, y, z, w], length),
  color: series<'color'>(['r', 'g', 'b', 'a'], ({ r, g, b, a }) => [r, g, b, a], length),
  quaternion,
  quaternionList: quaternion,
  pose2D: series<'pose2D'>(
    ['x', 'y', 'angle'],
    ({ position, angle: turn }) => [
      position?.x ?? Number.NaN,
      position?.y ?? Number.NaN,
      turn ?? Number.NaN,
    ],
    ([x = 0, y = 0]) => Math.hypot(x, y),
  ),
  pose3D: series<'pose3D'>(
    ['x', 'y', 'z'],
    ({ position }) => [
      position?.x ?? Number.NaN,
      position?.y ?? Number.NaN,
      position?.z ?? Number.NaN,
    ],
    length,
  ),
};

/** How a data format is drawn over time; `undefined` for those that are not numbers. */
export function seriesOf(format: DataFormat): ValueSeries | undefined {
  return SERIES[format];
}

/** The number a value is reduced to in a sparkline; `undefined` when it has none. */
export function summaryNumber(format: DataFormat, value: unknown): number | undefined {
  const list = LISTS.has(format) ? (value as { elements: readonly number[] }).elements : undefined;
  const known = SERIES[format];
  const number = list ? list[0] : known?.summary(known.read(value as never));
  return number === undefined || !Number.isFinite(number) ? undefined : number;
}

/** Lists of which the first number stands for all. */
const LISTS: ReadonlySet<DataFormat> = new Set<DataFormat>([
  'doubleList',
  'floatList',
  'int32List',
]);
