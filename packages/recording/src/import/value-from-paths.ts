import {
  DATA_FORMATS,
  DecodeError,
  fromJson,
  messageDescriptor,
  type DataFormat,
  type FieldDescriptor,
  type MessageDescriptor,
} from '@ubii/proto';
import { RecordingError } from '../records/recording-error.ts';

/**
 * The value of a data format from its leaves, as `flattenValue` gave them.
 *
 * @param leaves paths such as `position.x`, with numbers, truth values and texts, or these as texts
 * @throws RecordingError that names the leaf that does not fit
 */
export function valueFromPaths(
  format: DataFormat,
  leaves: Iterable<readonly [path: string, value: unknown]>,
): unknown {
  const field = fieldOf(format);
  let root: unknown = typeof field.type === 'object' ? {} : undefined;
  for (const [path, value] of leaves) {
    if (typeof field.type !== 'object') root = value;
    else if (field.type.kind === 'message') put(root as Tree, field.type, path.split('.'), value);
  }
  try {
    const record = fromJson('ubii.topicData.TopicDataRecord', { [format]: root });
    return record[format];
  } catch (error) {
    if (!(error instanceof DecodeError)) throw error;
    throw new RecordingError(`A value of format ${format} does not fit: ${error.message}`);
  }
}

/** Whether a data format can have these leaves, such as `x` and `y` of `vector2`. */
export function hasPaths(format: DataFormat, paths: readonly string[]): boolean {
  const { type } = fieldOf(format);
  if (typeof type !== 'object') return paths.length === 1 && paths[0] === 'value';
  if (type.kind !== 'message' || paths.length === 0) return false;
  const leaves = new Set(leavesOf(type, '', 0));
  return (
    paths.every((path) => leaves.has(path)) &&
    (paths.length === leaves.size || paths.some((path) => path.includes('.')))
  );
}

type Tree = Record<string, unknown>;

function fieldOf(format: DataFormat): FieldDescriptor {
  const { fieldNumber } = DATA_FORMATS[format];
  return messageDescriptor('ubii.topicData.TopicDataRecord').fieldByNumber.get(fieldNumber)!;
}

/** Puts a leaf where it belongs; numbers in a path are places in a list. Pixels are only told by their length: left out. */
function put(
  tree: Tree,
  message: MessageDescriptor,
  path: readonly string[],
  value: unknown,
): void {
  const [head = '', ...rest] = path;
  const isPlace = /^\d+$/.test(head);
  const name = isPlace && !message.fieldByName.has(head) ? 'elements' : head;
  const field = message.fieldByName.get(name);
  if (field === undefined || field.type === 'bytes') return;
  const [place, ...below] = name === head ? rest : path;
  if (field.repeated) {
    const list = (tree[field.jsonName] ??= []) as unknown[];
    const at = Number(place);
    if (!Number.isInteger(at) || at > MAX_PLACES) return;
    while (list.length < at) list.push(emptyOf(field));
    list[at] = placed(list[at], field, below, value);
  } else tree[field.jsonName] = placed(tree[field.jsonName], field, rest, value);
}

const MAX_PLACES = 100_000;

/** An element without cells: empty texts are empty cells. */
function emptyOf({ type }: FieldDescriptor): unknown {
  if (typeof type === 'object') return type.kind === 'message' ? {} : 0;
  return type === 'string' ? '' : 0;
}

function placed(
  known: unknown,
  { type }: FieldDescriptor,
  path: readonly string[],
  value: unknown,
): unknown {
  if (typeof type !== 'object' || type.kind !== 'message') return value;
  const child = (known ?? {}) as Tree;
  put(child, type, path, value);
  return child;
}

const MAX_DEPTH = 4;

function leavesOf(message: MessageDescriptor, prefix: string, depth: number): string[] {
  return message.fields.flatMap(({ jsonName, type, repeated }) => {
    if (repeated || depth > MAX_DEPTH) return [];
    const path = prefix === '' ? jsonName : `${prefix}.${jsonName}`;
    return typeof type === 'object' && type.kind === 'message'
      ? leavesOf(type, path, depth + 1)
      : [path];
  });
}
