import { isSameValue, type FieldDescriptor, type MessageDescriptor } from '@ubii/proto';

/** A decoded message. */
export type Fields = Record<string, unknown>;

/** What becomes of values that are personal in every message. */
export interface MessageTreatment {
  /** Of a text that may contain names or ids. */
  text(text: string): string;
  clientId(id: string): string;
  /** Of the code of a module. */
  code(code: string): string;
  /** @param prefix what has the name, such as `client` */
  name(name: string, prefix: string): string;
  /** Of an absolute time, milliseconds since the Unix epoch. */
  timeMs(timeMs: number): number;
}

/** Times before 2001-09-09 are durations, or of clocks that begin elsewhere. */
const EARLIEST_EPOCH_MS = 1e12;

type TextKind = 'text' | 'code' | 'clientId' | 'dropped' | { readonly prefix: string };

/** Texts whose member name states their kind, in every message. */
const BY_NAME: Readonly<Record<string, TextKind>> = {
  clientId: 'clientId',
  clientIds: 'clientId',
  nodeId: 'clientId',
  clientName: { prefix: 'client' },
  author: { prefix: 'client' },
  authors: { prefix: 'author' },
  hostIp: 'dropped',
  metadataJson: 'dropped',
  onProcessingStringified: 'code',
  onCreatedStringified: 'code',
  onHaltedStringified: 'code',
  onDestroyedStringified: 'code',
};

/** Texts of single messages. */
const BY_FIELD: Readonly<Record<string, TextKind>> = {
  'ubii.clients.Client.id': 'clientId',
  'ubii.clients.Client.name': { prefix: 'client' },
  'ubii.clients.Client.description': 'dropped',
  'ubii.devices.Device.name': { prefix: 'device' },
  'ubii.devices.Device.description': 'dropped',
};

const withTexts = new WeakMap<MessageDescriptor, boolean>();

/** Returns whether a message, or one in it, has texts. */
export function hasTexts(message: MessageDescriptor): boolean {
  const known = withTexts.get(message);
  if (known !== undefined) return known;
  const found = message.fields.some(
    ({ type }) => type === 'string' || (isMessage(type) && hasTexts(type)),
  );
  withTexts.set(message, found);
  return found;
}

/** Replaces texts and times in a decoded message, and in those in it. @returns whether something changed */
export function treatMessage(
  message: MessageDescriptor,
  value: Fields,
  treatment: MessageTreatment,
): boolean {
  let isChanged = false;
  for (const field of message.fields) {
    const before = value[field.jsonName];
    if (before === undefined) continue;
    const { type } = field;
    if (isMessage(type)) {
      for (const each of listOf(before)) {
        if (treatMessage(type, each as Fields, treatment)) isChanged = true;
      }
      continue;
    }
    const change = changeOf(message, field, treatment);
    if (change === undefined) continue;
    const after = Array.isArray(before) ? before.map(change) : change(before);
    isChanged ||= !isSameValue(before, after);
    value[field.jsonName] = after;
  }
  return isChanged;
}

function changeOf(
  { name }: MessageDescriptor,
  { type, jsonName }: FieldDescriptor,
  treatment: MessageTreatment,
): ((value: unknown) => unknown) | undefined {
  if (type === 'double' || type === 'int64') {
    if (!/(Ms|^millis)$/.test(jsonName)) return undefined;
    return (value) => (Number(value) < EARLIEST_EPOCH_MS ? value : treatment.timeMs(Number(value)));
  }
  if (type !== 'string') return undefined;
  const kind = BY_FIELD[`${name}.${jsonName}`] ?? BY_NAME[jsonName] ?? 'text';
  if (kind === 'code') return (value) => treatment.code(value as string);
  if (kind === 'dropped') return () => '';
  if (kind === 'text') return (value) => treatment.text(value as string);
  if (kind === 'clientId') return (value) => treatment.clientId(value as string);
  return (value) => treatment.name(value as string, kind.prefix);
}

function listOf(value: unknown): readonly unknown[] {
  return Array.isArray(value) ? value : [value];
}

/** Whether the type of a field is a message. */
export function isMessage(type: FieldDescriptor['type']): type is MessageDescriptor {
  return typeof type === 'object' && type.kind === 'message';
}
