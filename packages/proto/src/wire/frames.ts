import { encodeErrorMessage } from '../generated/codec.ts';
import type { ErrorMessage } from '../generated/messages.ts';
import type { Init } from '../init.ts';
import { createWriter } from '../protobuf.ts';
import { ERROR_TAG, LIST_ELEMENT_TAG, LIST_TAG, RECORD_TAG } from './tags.ts';

/**
 * The bytes that make an encoded record a frame: header followed by record is a `TopicData` with
 * `topic_data_record`.
 *
 * @param recordLength size of the encoded record in bytes
 */
export function recordFrameHeader(recordLength: number): Uint8Array {
  const header = new Uint8Array(1 + varintLength(recordLength));
  header[0] = RECORD_TAG;
  writeVarint(header, 1, recordLength);
  return header;
}

/**
 * A frame with a list of encoded records, in their order: `TopicData` with `topic_data_record_list`.
 * Only for clients that asked for lists. [TD-4]
 */
export function encodeRecordListFrame(records: readonly Uint8Array[]): Uint8Array {
  let listLength = 0;
  for (const record of records) {
    listLength += 1 + varintLength(record.length) + record.length;
  }
  const frame = new Uint8Array(1 + varintLength(listLength) + listLength);
  frame[0] = LIST_TAG;
  let pos = writeVarint(frame, 1, listLength);
  for (const record of records) {
    frame[pos] = LIST_ELEMENT_TAG;
    pos = writeVarint(frame, pos + 1, record.length);
    frame.set(record, pos);
    pos += record.length;
  }
  return frame;
}

/** A frame with an error: `TopicData` with `error`. [TD-17] */
export function encodeErrorFrame(error: Init<ErrorMessage>): Uint8Array {
  const writer = createWriter();
  writer.uint32(ERROR_TAG).fork();
  encodeErrorMessage(error, writer);
  return writer.ldelim().finish();
}

function varintLength(value: number): number {
  if (value < 0x80) return 1;
  if (value < 0x4000) return 2;
  if (value < 0x20_0000) return 3;
  return value < 0x1000_0000 ? 4 : 5;
}

function writeVarint(target: Uint8Array, start: number, value: number): number {
  let pos = start;
  let rest = value;
  while (rest >= 0x80) {
    target[pos++] = (rest & 0x7f) | 0x80;
    rest >>>= 7;
  }
  target[pos++] = rest;
  return pos;
}
