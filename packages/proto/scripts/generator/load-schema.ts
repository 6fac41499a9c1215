/** Reads schema/*.proto into a small model of our own. The only place where protobufjs reflection runs. */
import { readdirSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import protobuf from 'protobufjs';

export type ScalarName = 'double' | 'float' | 'int32' | 'int64' | 'bool' | 'string' | 'bytes';

export interface EnumModel {
  /** Full name, `ubii.clients.Client.State`. */
  fullName: string;
  /** Name of the exported const object, `ClientState`. */
  tsName: string;
  comment: string;
  values: { name: string; number: number; comment: string }[];
}

export interface FieldModel {
  number: number;
  /** Name in the schema, snake_case. */
  name: string;
  /** lowerCamelCase name: the JSON key and the property of the decoded object. */
  jsonName: string;
  comment: string;
  repeated: boolean;
  /** jsonName-like name of the oneof this is a member of. */
  oneof: string | undefined;
  type: ScalarName | EnumModel | MessageModel;
}

export interface MessageModel {
  fullName: string;
  tsName: string;
  comment: string;
  /** Source file, relative to schema/. */
  file: string;
  /** By field number. */
  fields: FieldModel[];
}

export interface SchemaModel {
  messages: MessageModel[];
  enums: EnumModel[];
}

const SCALARS = new Set<string>(['double', 'float', 'int32', 'int64', 'bool', 'string', 'bytes']);
/** Names that a browser already uses for something else. */
const GLOBAL_NAMES = new Set(['Error', 'MouseEvent', 'TouchEvent']);

/**
 * Loads every .proto file below a folder.
 *
 * @param schemaFolder absolute path of packages/proto/schema
 * @throws Error when the schema uses something the emitted code does not support
 */
export function loadSchema(schemaFolder: string): SchemaModel {
  const root = loadRoot(schemaFolder);

  const types: protobuf.Type[] = [];
  const enumerations: protobuf.Enum[] = [];
  collect(root, types, enumerations);
  const enums = new Map(enumerations.map((e) => [e as protobuf.ReflectionObject, enumModel(e)]));
  const messages = new Map(
    types.map((t) => [t as protobuf.ReflectionObject, messageModel(t, schemaFolder)]),
  );
  for (const type of types) {
    const model = messages.get(type)!;
    for (const field of type.fieldsArray) {
      model.fields.push(fieldModel(field, (object) => messages.get(object) ?? enums.get(object)));
    }
    model.fields.sort((a, b) => a.number - b.number);
  }
  const schema = {
    messages: [...messages.values()].sort(byFullName),
    enums: [...enums.values()].sort(byFullName),
  };
  refuseCycles(schema.messages);
  return schema;
}

/** Loads every .proto file below a folder, as protobufjs has them. @param schemaFolder absolute path */
export function loadRoot(schemaFolder: string): protobuf.Root {
  const files = readdirSync(schemaFolder, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.proto'))
    .map((file) => file.split(sep).join('/'))
    .sort();
  const root = new protobuf.Root();
  root.resolvePath = (_origin, target) => join(schemaFolder, relative('/', join('/', target)));
  root.loadSync(files, { keepCase: true, alternateCommentMode: true });
  root.resolveAll();
  return root;
}

function collect(parent: protobuf.NamespaceBase, types: protobuf.Type[], enums: protobuf.Enum[]) {
  for (const child of parent.nestedArray) {
    if (child instanceof protobuf.Enum) enums.push(child);
    if (child instanceof protobuf.Type) types.push(child);
    if (child instanceof protobuf.Namespace) collect(child, types, enums);
  }
}

function fullNameOf(object: protobuf.ReflectionObject): string {
  return object.fullName.replace(/^\./, '');
}

/** Nested names are joined, unless the nested name already starts with the outer one. */
function tsNameOf(object: protobuf.ReflectionObject): string {
  const outer = object.parent instanceof protobuf.Type ? object.parent.name : '';
  if (outer !== '') return object.name.startsWith(outer) ? object.name : outer + object.name;
  return GLOBAL_NAMES.has(object.name) ? `${object.name}Message` : object.name;
}

function enumModel(object: protobuf.Enum): EnumModel {
  const values = Object.entries(object.values)
    .map(([name, number]) => ({ name, number, comment: object.comments[name] ?? '' }))
    .sort((a, b) => a.number - b.number);
  if (values[0]?.number !== 0) throw new Error(`${object.fullName}: the first value must be 0`);
  return {
    fullName: fullNameOf(object),
    tsName: tsNameOf(object),
    comment: object.comment ?? '',
    values,
  };
}

function messageModel(object: protobuf.Type, schemaFolder: string): MessageModel {
  return {
    fullName: fullNameOf(object),
    tsName: tsNameOf(object),
    comment: object.comment ?? '',
    file: relative(schemaFolder, object.filename ?? '')
      .split(sep)
      .join('/'),
    fields: [],
  };
}

function fieldModel(
  field: protobuf.Field,
  modelOf: (object: protobuf.ReflectionObject) => MessageModel | EnumModel | undefined,
): FieldModel {
  const type = field.resolvedType ? modelOf(field.resolvedType) : field.type;
  if (field.map || field.required || field.options?.['proto3_optional'] === true) {
    throw new Error(`${field.fullName}: maps, required and optional are not supported`);
  }
  if (field.repeated && type === 'int64') {
    throw new Error(`${field.fullName}: lists of int64 are not supported`);
  }
  if (type === undefined || (typeof type === 'string' && !SCALARS.has(type))) {
    throw new Error(`${field.fullName}: the type ${field.type} is not supported`);
  }
  return {
    number: field.id,
    name: field.name,
    jsonName: camelCase(field.name),
    comment: field.comment ?? '',
    repeated: field.repeated,
    oneof: field.partOf?.name,
    type: type as FieldModel['type'],
  };
}

/** The JSON name rule of proto3: an underscore is dropped and the letter after it is upper-cased. */
function camelCase(name: string): string {
  return name.replace(/_+(.)/g, (_match, letter: string) => letter.toUpperCase());
}

function byFullName(a: { fullName: string }, b: { fullName: string }): number {
  return a.fullName < b.fullName ? -1 : 1;
}

/**
 * The emitted decoders, the JSON reader and the wire check recurse along the schema. As long as no
 * message contains itself, hostile input cannot make them go deeper than the schema does, and none
 * of them needs a depth counter.
 */
function refuseCycles(messages: readonly MessageModel[]): void {
  const done = new Set<MessageModel>();
  const visit = (message: MessageModel, path: readonly MessageModel[]): void => {
    if (path.includes(message)) {
      throw new Error(
        `${message.fullName} contains itself: add a depth limit to the decoders before the schema may be recursive`,
      );
    }
    if (done.has(message)) return;
    for (const field of message.fields) {
      if (typeof field.type === 'object' && 'fields' in field.type) {
        visit(field.type, [...path, message]);
      }
    }
    done.add(message);
  };
  for (const message of messages) visit(message, []);
}

export function isMessage(type: FieldModel['type']): type is MessageModel {
  return typeof type === 'object' && 'fields' in type;
}

export function isEnum(type: FieldModel['type']): type is EnumModel {
  return typeof type === 'object' && 'values' in type;
}
