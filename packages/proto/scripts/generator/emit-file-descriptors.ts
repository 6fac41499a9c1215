/** Emits descriptors of .proto files, for programs that read messages without knowing our schema. */
import { createRequire } from 'node:module';
import { relative, sep } from 'node:path';
import protobuf from 'protobufjs';
import { HEADER } from './emit-messages.ts';

/** `FieldDescriptorProto.Type` of the types that the schema uses. */
const SCALARS: Readonly<Record<string, number>> = {
  double: 1,
  float: 2,
  int64: 3,
  int32: 5,
  bool: 8,
  string: 9,
  bytes: 12,
};
const MESSAGE = 11;
const ENUM = 14;
const OPTIONAL = 1;
const REPEATED = 3;

/**
 * Source of a file with a serialised `FileDescriptorSet`: the files of a message and of all messages within, each after
 * those that it needs, without comments.
 *
 * @param schemaFolder absolute path of schema/, which the names of the files are relative to
 */
export function emitFileDescriptors(
  root: protobuf.Root,
  message: string,
  schemaFolder: string,
): string {
  const files = new Map<string, object>();
  const nameOf = (type: protobuf.ReflectionObject): string =>
    relative(schemaFolder, type.filename!).split(sep).join('/');
  const add = (first: protobuf.Type | protobuf.Enum): void => {
    const name = nameOf(first);
    if (files.has(name)) return;
    const neighbours = first.parent!.nestedArray.filter(
      (object) => object.filename === first.filename,
    );
    const types = neighbours.filter((object) => object instanceof protobuf.Type);
    const enums = neighbours.filter((object) => object instanceof protobuf.Enum);
    const needed = types.flatMap(typesWithin).filter((type) => nameOf(type) !== name);
    needed.forEach(add);
    files.set(name, {
      name,
      syntax: 'proto3',
      package: first.parent!.fullName.slice(1),
      dependency: [...new Set(needed.map(nameOf))],
      messageType: types.map(messageDescriptor),
      enumType: enums.map(enumDescriptor),
    });
  };
  add(root.lookupType(message));
  const text = encodeFileDescriptors([...files.values()]).toString('base64');
  const lines = text.match(/.{1,96}/g) ?? [];
  return `${HEADER}
/** A serialised \`google.protobuf.FileDescriptorSet\` for \`${message}\`, in base64 with line ends. */
export const RECORD_SCHEMA = \`
${lines.join('\n')}
\`;
`;
}

function encodeFileDescriptors(file: object[]): Buffer {
  const require = createRequire(import.meta.url);
  const json = require('protobufjs/google/protobuf/descriptor.json') as protobuf.INamespace;
  const set = protobuf.Root.fromJSON(json).lookupType('google.protobuf.FileDescriptorSet');
  return Buffer.from(set.encode(set.fromObject({ file })).finish());
}

/** The messages and enums in the fields of a message; of a nested one, the outermost around it. */
function typesWithin(type: protobuf.Type): (protobuf.Type | protobuf.Enum)[] {
  const own = type.fieldsArray.flatMap(({ resolvedType }) => resolvedType ?? []).map(outermost);
  const nested = type.nestedArray.filter((object) => object instanceof protobuf.Type);
  return [...own, ...nested.flatMap(typesWithin)];
}

function outermost(type: protobuf.Type | protobuf.Enum): protobuf.Type | protobuf.Enum {
  return type.parent instanceof protobuf.Type ? outermost(type.parent) : type;
}

function messageDescriptor(type: protobuf.Type): object {
  return {
    name: type.name,
    field: type.fieldsArray.map((field) => fieldDescriptor(type, field)),
    oneofDecl: type.oneofsArray.map(({ name }) => ({ name })),
    nestedType: type.nestedArray
      .filter((object) => object instanceof protobuf.Type)
      .map(messageDescriptor),
    enumType: type.nestedArray
      .filter((object) => object instanceof protobuf.Enum)
      .map(enumDescriptor),
  };
}

function fieldDescriptor(type: protobuf.Type, field: protobuf.Field): object {
  const { resolvedType } = field;
  const kind = resolvedType instanceof protobuf.Enum ? ENUM : MESSAGE;
  return {
    name: field.name,
    number: field.id,
    label: field.repeated ? REPEATED : OPTIONAL,
    type: resolvedType ? kind : SCALARS[field.type],
    ...(resolvedType && { typeName: resolvedType.fullName }),
    ...(field.partOf && { oneofIndex: type.oneofsArray.indexOf(field.partOf) }),
  };
}

function enumDescriptor({ name, values }: protobuf.Enum): object {
  return {
    name,
    value: Object.entries(values).map(([value, number]) => ({ name: value, number })),
  };
}
