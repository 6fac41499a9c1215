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

type Formatter<F extends DataFormat> = (value: DataFormatValues[F]) => string;

/** Longest text, characters; no row is wider. */
const MAX_TEXT = 200;
/** Longest list that is written out; for longer ones, the number of elements. */
const MAX_WRITTEN = 4;
/** Most objects of a list that are named. */
const MAX_NAMED = 8;

/**
 * Formats a value in one line, for rows. Decimals are fixed per data format, so that digits do not jump while a value
 * changes; values that would round to 0 have an exponent.
 */
export function formatValue<F extends DataFormat>(format: F, value: DataFormatValues[F]): string {
  return FORMATTERS[format](value);
}

/** Formats a number with fixed decimals and a minus sign; tiny numbers with an exponent instead of as 0. */
export function formatFixed(value: number, decimals: number): string {
  if (value !== 0 && Math.abs(value) < 0.5 * 10 ** -decimals) {
    return value.toExponential(1).replaceAll('-', '−');
  }
  return formatNumber(value, decimals);
}

const numbers =
  (decimals: number) =>
  (...values: number[]): string =>
    values.map((value) => formatFixed(value, decimals)).join(', ');

const two = numbers(2);
const three = numbers(3);
const integers = numbers(0);

const vector3 = ({ x, y, z }: Vector3): string => two(x, y, z);

/** `[a, b]` for short lists; `7 × vector2` for long ones, and for elements that are not single numbers. */
function list<T>(
  elements: readonly T[],
  format: DataFormat,
  write?: (element: T) => string,
): string {
  if (write && elements.length <= MAX_WRITTEN) return `[${elements.map(write).join(', ')}]`;
  return `${elements.length} × ${format}`;
}

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
  double: two,
  float: two,
  int32: integers,
  bool: String,
  string: text,
  vector2: ({ x, y }) => three(x, y),
  vector3,
  vector4: ({ x, y, z, w }) => two(x, y, z, w),
  quaternion: ({ x, y, z, w }) => `x ${two(x)} y ${two(y)} z ${two(z)} w ${two(w)}`,
  quaternionList: (value) => formatValue('quaternion', value),
  matrix3x2: (value) => two(...Object.values(value)),
  matrix4x4: (value) => two(...Object.values(value)),
  color: ({ r, g, b, a }) => two(r, g, b, a),
  touchEvent: ({ type, position }) =>
    `${nameOf(TouchEventType, type)}${position ? ` ${three(position.x, position.y)}` : ''}`,
  touchEventList: ({ elements }) =>
    named(
      'touch',
      'touches',
      elements.map(({ type }) => nameOf(TouchEventType, type)),
    ),
  keyEvent: ({ key, type }) => `${text(key)} ${nameOf(ButtonEventType, type)}`,
  mouseEvent: ({ button, type }) => `button ${button} ${nameOf(ButtonEventType, type)}`,
  myoEvent: ({ gesture }) => nameOf(HandGestureType, gesture),
  pose2D: ({ position, angle, direction }) =>
    [
      three(position?.x ?? 0, position?.y ?? 0),
      angle === undefined ? undefined : `angle ${two(angle)}`,
      direction && `towards ${two(direction.x, direction.y)}`,
    ]
      .filter(Boolean)
      .join(' '),
  pose3D: ({ position, quaternion, euler }) =>
    [
      vector3(position ?? { x: 0, y: 0, z: 0 }),
      quaternion && formatValue('quaternion', quaternion),
      euler && `euler ${vector3(euler)}`,
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
  int32List: ({ elements }) => list(elements, 'int32', (value) => integers(value)),
  floatList: ({ elements }) => list(elements, 'float', (value) => two(value)),
  doubleList: ({ elements }) => list(elements, 'double', (value) => two(value)),
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
