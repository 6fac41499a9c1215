import {
  ButtonEventType,
  HandGestureType,
  Image2DDataFormat,
  ModuleEventKind,
  TouchEventType,
  isCompressedImage,
  type DataFormat,
  type DataFormatValues,
  type Image2D,
  type Vector3,
} from '@ubii/proto';
import { counted } from '@ubii/words';
import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { reachOf } from './reach.ts';

type Formatter<F extends DataFormat> = (value: DataFormatValues[F], reach: number) => string;

/** Longest text, characters; no row is wider. */
const MAX_TEXT = 200;
/** Longest list that is written out; for longer ones, the number of elements. */
const MAX_WRITTEN = 4;
/** Most objects of a list that are named. */
const MAX_NAMED = 8;

/** Decimals of numbers; smaller ones have an exponent. */
const MAX_DECIMALS = 6;

/**
 * Formats a value in one line, for rows. Decimals are fixed per data format, so that digits do not jump while a value
 * changes; there are more where all recent values are small.
 * @param reach largest magnitude of the recent values
 */
export function formatValue<F extends DataFormat>(
  format: F,
  value: DataFormatValues[F],
  reach = 0,
): string {
  return FORMATTERS[format](value, reach);
}

/**
 * Formats a number with fixed decimals and a minus sign. Numbers of one reach have the same decimals: more than asked for
 * when all would be 0, and an exponent below that.
 * @param reach largest magnitude in the column, series or value
 */
export function formatFixed(value: number, decimals: number, reach = Math.abs(value)): string {
  // Two significant digits of the largest.
  const needed = reach > 0 && Number.isFinite(reach) ? 1 - Math.floor(Math.log10(reach)) : 0;
  if (needed > MAX_DECIMALS) return value.toExponential(1).replaceAll('-', '−');
  // One digit of the largest is enough.
  return formatNumber(value, needed > decimals + 1 ? needed : decimals);
}

/**
 * Formats a number for an axis, or for all numbers of a plot: three significant digits of the range, the same decimals for
 * all.
 */
export function formatInRange(value: number, { min, max }: NumberRange): string {
  const span = max - min || Math.max(Math.abs(min), Math.abs(max)) || 1;
  const decimals = 2 - Math.floor(Math.log10(span));
  const reach = Math.max(Math.abs(min), Math.abs(max));
  if (decimals > MAX_DECIMALS + 2 && reach < 10 ** -MAX_DECIMALS) {
    return value.toExponential(2).replaceAll('-', '−');
  }
  return formatNumber(value, Math.min(MAX_DECIMALS + 2, Math.max(0, decimals)));
}

/** Lowest and highest number of a series. */
export interface NumberRange {
  readonly min: number;
  readonly max: number;
}

/** Formats the numbers of one value alike. */
const numbers =
  (decimals: number) =>
  (values: readonly number[], reach = 0): string => {
    const all = Math.max(reach, reachOf(values));
    return values.map((value) => formatFixed(value, decimals, all)).join(', ');
  };

const two = numbers(2);
const three = numbers(3);
const integers = numbers(0);

const vector3 = ({ x, y, z }: Vector3, reach = 0): string => two([x, y, z], reach);
/** Parts of a rotation are at most 1. */
const part = (value: number): string => formatFixed(value, 2, 1);

/** `[a, b]` for short lists; `7 × vector2` for long ones, and for elements that are not single numbers. */
function list<T>(
  elements: readonly T[],
  format: DataFormat,
  write?: (element: T) => string,
): string {
  if (write && elements.length <= MAX_WRITTEN) return `[${elements.map(write).join(', ')}]`;
  return `${elements.length} × ${format}`;
}

const numberList = (elements: readonly number[], format: DataFormat, reach: number): string => {
  const all = Math.max(reach, reachOf(elements.slice(0, MAX_WRITTEN)));
  return list(elements, format, (value) => two([value], all));
};

/** Number of objects and their first names: `2 objects: cup, person`. */
function named(one: string, many: string, names: readonly string[]): string {
  const count = counted(names.length, one, many);
  const first = names.filter((name) => name !== '').slice(0, MAX_NAMED);
  return first.length === 0 ? count : `${count}: ${text(first.map(cut).join(', '))}`;
}

const cut = (text: string): string =>
  text.length > MAX_TEXT ? `${text.slice(0, MAX_TEXT)}…` : text;

/** Text in one line; `""` for an empty one. */
const text = (value: string): string => (value === '' ? '""' : cut(value).replace(/\s+/g, ' '));

function nameOf(names: Readonly<Record<string, number>>, value: number): string {
  const name = Object.keys(names).find((key) => names[key] === value);
  return name?.toLowerCase() ?? String(value);
}

/** Dimensions, encoding and size: `640×480 JPEG, 38 kB`. */
export function formatImage({ width, height, dataFormat, data }: Image2D): string {
  const { digits, unit } = formatBytes(data.length);
  const kind = imageKind(data) ?? nameOf(Image2DDataFormat, dataFormat).toUpperCase();
  const size = width > 0 && height > 0 ? `${width}×${height} ` : '';
  return `${size}${kind}, ${digits} ${unit ?? ''}`;
}

/** File format of an encoded picture, by its first byte. */
function imageKind(data: Uint8Array): string | undefined {
  if (!isCompressedImage(data)) return undefined;
  return { 0xff: 'JPEG', 0x89: 'PNG', 0x52: 'WebP' }[data[0]!];
}

const FORMATTERS: { readonly [F in DataFormat]: Formatter<F> } = {
  double: (value, reach) => two([value], reach),
  float: (value, reach) => two([value], reach),
  int32: (value) => integers([value]),
  bool: String,
  string: text,
  vector2: ({ x, y }, reach) => three([x, y], reach),
  vector3,
  vector4: ({ x, y, z, w }, reach) => two([x, y, z, w], reach),
  quaternion: ({ x, y, z, w }) => `x ${part(x)} y ${part(y)} z ${part(z)} w ${part(w)}`,
  quaternionList: (value) => formatValue('quaternion', value),
  matrix3x2: (value) => two(Object.values(value)),
  matrix4x4: (value) => two(Object.values(value)),
  color: ({ r, g, b, a }) => two([r, g, b, a], 1),
  touchEvent: ({ type, position }) =>
    `${nameOf(TouchEventType, type)}${position ? ` ${three([position.x, position.y], 1)}` : ''}`,
  touchEventList: ({ elements }) =>
    named(
      'touch',
      'touches',
      elements.map(({ type }) => nameOf(TouchEventType, type)),
    ),
  keyEvent: ({ key, type }) => `${text(key)} ${nameOf(ButtonEventType, type)}`,
  mouseEvent: ({ button, type }) => `button ${button} ${nameOf(ButtonEventType, type)}`,
  myoEvent: ({ gesture }) => nameOf(HandGestureType, gesture),
  pose2D: ({ position, angle, direction }, reach) =>
    [
      three([position?.x ?? 0, position?.y ?? 0], reach),
      angle === undefined ? undefined : `angle ${part(angle)}`,
      direction && `towards ${two([direction.x, direction.y], 1)}`,
    ]
      .filter(Boolean)
      .join(' '),
  pose3D: ({ position, quaternion, euler }, reach) =>
    [
      vector3(position ?? { x: 0, y: 0, z: 0 }, reach),
      quaternion && formatValue('quaternion', quaternion),
      euler && `euler ${vector3(euler, 1)}`,
    ]
      .filter(Boolean)
      .join(' '),
  object2D: ({ id, pose }) =>
    [text(id), pose && formatValue('pose2D', pose)].filter(Boolean).join(' '),
  object3D: ({ id, pose }) =>
    [text(id), pose && formatValue('pose3D', pose)].filter(Boolean).join(' '),
  object2DList: ({ elements }) =>
    named(
      'object',
      'objects',
      elements.map(({ id }) => id),
    ),
  object3DList: ({ elements }) =>
    named(
      'object',
      'objects',
      elements.map(({ id }) => id),
    ),
  int32List: ({ elements }) => list(elements, 'int32', (value) => integers([value])),
  floatList: ({ elements }, reach) => numberList(elements, 'float', reach),
  doubleList: ({ elements }, reach) => numberList(elements, 'double', reach),
  stringList: ({ elements }) =>
    cut(list(elements, 'string', (value) => JSON.stringify(cut(value)))),
  boolList: ({ elements }) => list(elements, 'bool', String),
  vector2List: ({ elements }) => list(elements, 'vector2'),
  vector3List: ({ elements }) => list(elements, 'vector3'),
  vector4List: ({ elements }) => list(elements, 'vector4'),
  image2D: formatImage,
  image2DList: ({ elements }) => list(elements, 'image2D'),
  session: ({ name, id }) => text(name || id),
  sessionList: ({ elements }) =>
    named(
      'session',
      'sessions',
      elements.map(({ name }) => name),
    ),
  device: ({ name, id }) => text(name || id),
  deviceList: ({ elements }) =>
    named(
      'device',
      'devices',
      elements.map(({ name }) => name),
    ),
  component: ({ name, topic, id }) => text(name || topic || id),
  componentList: ({ elements }) =>
    named(
      'component',
      'components',
      elements.map(({ name }) => name),
    ),
  error: ({ title, message }) => text([title, message].filter(Boolean).join(': ')),
  client: ({ name, id }) => text(name || id),
  sessionStatistics: ({ modules }) =>
    named(
      'module',
      'modules',
      modules.map(({ moduleName }) => moduleName),
    ),
  moduleEvent: ({ moduleName, moduleId, kind, message }) => {
    const what = [moduleName || moduleId, nameOf(ModuleEventKind, kind)].filter(Boolean).join(' ');
    return text([what, message].filter(Boolean).join(': '));
  },
  recordingStatus: ({ running }) =>
    named(
      'recording',
      'recordings',
      running.map(({ name }) => name),
    ),
  replayList: ({ elements }) =>
    named(
      'replay',
      'replays',
      elements.map(({ name }) => name),
    ),
  studyStatus: ({ runs }) => counted(runs.length, 'run', 'runs'),
};
