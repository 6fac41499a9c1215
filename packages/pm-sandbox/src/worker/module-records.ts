import { decode, DecodeError, isRecordMember, type TopicDataRecord } from '@ubii/proto';
import type { SandboxInput, SandboxRecord } from '../ports/sandbox.ts';
import { ModuleError, moduleFault } from './module-error.ts';

/** A record as a module sees it, before its type is known. [PM-30] */
export type DecodedRecord = TopicDataRecord & {
  type: string;
  identity?: string;
  receivedAtMs?: number;
};

/** Values of inputs by name, as `onProcessing` gets them. */
export type InputValues = Record<string, unknown>;

/**
 * Decodes inputs into the convention of the wire: whole records for topics, lists of them for muxers.
 * The data of pictures is a view of the bytes. [PM-30] [PM-40]
 *
 * @throws ModuleError when bytes are no record
 */
export function decodeInputs(inputs: readonly SandboxInput[]): InputValues {
  const values: InputValues = {};
  for (const input of inputs) {
    const value =
      'elements' in input
        ? { elements: input.elements.map((element) => decodeElement(input.name, element)) }
        : input.record && decodeElement(input.name, input.record);
    // An input may be called __proto__: assigning would change the object instead.
    if (input.name === '__proto__') {
      Object.defineProperty(values, input.name, { value, enumerable: true });
    } else values[input.name] = value;
  }
  return values;
}

function decodeElement(input: string, element: SandboxRecord): DecodedRecord {
  const { bytes, identity, receivedAtMs } = element;
  const record = decodeOne(input, bytes) as DecodedRecord;
  record.type = valueMember(record);
  if (identity !== undefined) record.identity = identity;
  if (receivedAtMs !== undefined) record.receivedAtMs = receivedAtMs;
  return record;
}

function decodeOne(input: string, bytes: Uint8Array): TopicDataRecord {
  try {
    return decode('ubii.topicData.TopicDataRecord', bytes);
  } catch (cause) {
    if (!(cause instanceof DecodeError)) throw cause;
    const message = `The record for input "${input}" cannot be read: ${cause.message}`;
    throw new ModuleError(moduleFault('record', 'onProcessing', message), { cause });
  }
}

function valueMember(record: TopicDataRecord): string {
  let type = '';
  for (const member in record) {
    if (!isRecordMember(member)) type = member;
  }
  return type;
}
