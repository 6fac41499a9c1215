import { constantRecord } from '@ubii/pm-sandbox';
import {
  DATA_FORMATS,
  decodeRecord,
  fromJson,
  isMessageType,
  toJson,
  type IOMapping,
  type JsonValue,
  type ProcessingModule,
} from '@ubii/proto';
import { isRecordedDevice, type RecordedDevice } from '@ubii/recording';

/** A record of a case. */
export interface CaseRecord {
  /** Since the beginning of the case, milliseconds. */
  readonly atMs: number;
  readonly topic: string;
  /** Client id of the publisher; empty for the master. */
  readonly publisherId: string;
  /** One member of a record, such as `{"vector2":{"x":1}}`. */
  readonly record: JsonValue;
}

/** Recorded inputs of a module, and what it made of them. */
export interface ModuleCase {
  readonly name: string;
  /** Time of day at its beginning, milliseconds since the Unix epoch. */
  readonly startMs: number;
  readonly durationMs: number;
  /** Numbers are the same when they differ by at most this share of the larger one, or of 1. */
  readonly tolerance: number;
  /** The module as it was recorded, and its connections. */
  readonly module: ProcessingModule;
  readonly mapping: IOMapping;
  /** Devices with the components that inputs select, as they were recorded. */
  readonly devices: readonly RecordedDevice[];
  /** Values that the inputs had at the beginning. */
  readonly before: readonly CaseRecord[];
  /** In the order of time, as the outputs. */
  readonly inputs: readonly CaseRecord[];
  readonly outputs: readonly CaseRecord[];
}

const KIND = 'ubi-interact module case';
const VERSION = 1;

/** Writes a case as the text of a file. */
export function caseText({ module, mapping, ...rest }: ModuleCase): string {
  const file = {
    kind: KIND,
    version: VERSION,
    ...rest,
    module: toJson('ubii.processing.ProcessingModule', module),
    mapping: toJson('ubii.sessions.IOMapping', mapping),
  };
  return `${JSON.stringify(file, undefined, 1)}\n`;
}

/** @throws Error with a sentence when the text is not that of a case */
export function readCase(text: string): ModuleCase {
  let file: Partial<Record<string, unknown>>;
  try {
    file = JSON.parse(text) as typeof file;
  } catch {
    throw new Error('The file is not JSON.');
  }
  if (file['kind'] !== KIND || file['version'] !== VERSION)
    throw new Error('The file is not a test case of a module, or it is of a later version.');
  const number = (key: string): number => {
    if (typeof file[key] !== 'number') throw new Error(`The file has no number "${key}".`);
    return file[key];
  };
  return {
    name: String(file['name']),
    startMs: number('startMs'),
    durationMs: number('durationMs'),
    tolerance: number('tolerance'),
    module: fromJson('ubii.processing.ProcessingModule', file['module']),
    mapping: fromJson('ubii.sessions.IOMapping', file['mapping']),
    devices: devicesIn(file['devices']),
    before: recordsIn(file['before'], 'before'),
    inputs: recordsIn(file['inputs'], 'inputs'),
    outputs: recordsIn(file['outputs'], 'outputs'),
  };
}

function recordsIn(list: unknown, key: string): CaseRecord[] {
  if (!Array.isArray(list) || !list.every(isRecord))
    throw new Error(`The file has no list of records "${key}".`);
  return list;
}

/** Files of earlier versions have none. */
function devicesIn(list: unknown = []): RecordedDevice[] {
  if (!Array.isArray(list) || !list.every(isRecordedDevice))
    throw new Error('The file has no list of devices "devices".');
  return list;
}

function isRecord(one: unknown): one is CaseRecord {
  if (typeof one !== 'object' || one === null) return false;
  const { atMs, topic, publisherId, record } = one as Partial<CaseRecord>;
  return (
    typeof atMs === 'number' &&
    typeof topic === 'string' &&
    typeof publisherId === 'string' &&
    typeof record === 'object'
  );
}

/** The value of an encoded record as JSON; undefined when it has none. */
export function recordJson(bytes: Uint8Array): JsonValue | undefined {
  const { format, value } = decodeRecord(bytes);
  if (format === undefined) return undefined;
  const { messageType } = DATA_FORMATS[format];
  const json = isMessageType(messageType) ? toJson(messageType, value as never) : value;
  return { [format]: json as JsonValue };
}

/** Encodes a record of a case. @throws Error with a sentence when it cannot be read */
export function encodeCaseRecord({ topic, record }: CaseRecord): Uint8Array {
  const read = constantRecord(JSON.stringify(record), undefined);
  if ('problem' in read) throw new Error(`A record of ${topic} cannot be read: ${read.problem}.`);
  return read.bytes;
}
