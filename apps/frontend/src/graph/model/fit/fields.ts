import { DATA_FORMATS, isDataFormat, type DataFormat } from '@ubii/proto';

/** Part of a value that is a value of a data format itself. */
export interface Field {
  /** Path such as `position.x`. */
  readonly path: string;
  readonly format: DataFormat;
}

const CACHE = new Map<DataFormat, readonly Field[]>();

/** Parts of the values of a format, outer ones first: `position`, `position.x`. */
export function fieldsOf(format: DataFormat): readonly Field[] {
  let fields = CACHE.get(format);
  if (fields === undefined) {
    fields = [...findFields(format)];
    CACHE.set(format, fields);
  }
  return fields;
}

function* findFields(format: DataFormat): Iterable<Field> {
  const single = format.replace(/List$/, '');
  if (DATA_FORMATS[format].isList && isDataFormat(single)) {
    yield { path: 'elements.0', format: single };
    for (const { path, format } of fieldsOf(single)) yield { path: `elements.0.${path}`, format };
    return;
  }
  yield* fieldsIn(DATA_FORMATS[format].createDefault(), '');
}

function* fieldsIn(value: unknown, prefix: string): Iterable<Field> {
  if (typeof value !== 'object' || value === null) return;
  if (value instanceof Uint8Array) return;
  const inner: [string, unknown][] = [];
  for (const [name, member] of Object.entries(value)) {
    const path = prefix === '' ? name : `${prefix}.${name}`;
    const format = formatOf(name, member);
    if (format !== undefined) yield { path, format };
    inner.push([path, member]);
  }
  for (const [path, member] of inner) if (!Array.isArray(member)) yield* fieldsIn(member, path);
}

/** Data formats of members, by the names of their members. */
const SHAPES: Readonly<Record<string, DataFormat>> = {
  'x y': 'vector2',
  'x y z': 'vector3',
  'x y z w': 'vector4',
  'w x y z': 'vector4',
  'r g b a': 'color',
};

function formatOf(name: string, value: unknown): DataFormat | undefined {
  switch (typeof value) {
    case 'number':
      return 'double';
    case 'boolean':
      return 'bool';
    case 'string':
      return 'string';
    case 'object': {
      if (value === null) return undefined;
      const shape = SHAPES[Object.keys(value).join(' ')];
      return shape === 'vector4' && name.toLowerCase().includes('quaternion')
        ? 'quaternion'
        : shape;
    }
    default:
      return undefined;
  }
}
