import { varintSize, writeVarint } from '../binary/varint.ts';
import { writeMessage } from '../binary/write-message.ts';
import { encodeErrorMessage, encodeNodeMessage } from '../generated/codec.ts';
import type { ErrorMessage, NodeMessage } from '../generated/messages.ts';
import type { Init } from '../init.ts';
import { ERROR_TAG, LIST_ELEMENT_TAG, LIST_TAG, NODE_MESSAGE_TAG, RECORD_TAG } from './tags.ts';

/**
 * The bytes that make an encoded record a frame: header followed by record is a `TopicData` with
 * `topic_data_record`.
 *
 * @param recordLength size of the encoded record in bytes
 */
export function recordFrameHeader(recordLength: number): Uint8Array {
  const header = new Uint8Array(recordHeaderSize(recordLength));
  writeRecordHeader(header, 0, recordLength);
  return header;
}

/** Bytes that `writeRecordHeader` writes for a record of this length. */
export function recordHeaderSize(recordLength: number): number {
  return 1 + varintSize(recordLength);
}

/**
 * Writes what `recordFrameHeader` returns where the frame is being put together.
 *
 * @param start position of the header in `target`
 * @returns the position after it, where the record belongs
 */
export function writeRecordHeader(target: Uint8Array, start: number, recordLength: number): number {
  target[start] = RECORD_TAG;
  return writeVarint(target, start + 1, recordLength);
}

/** Bytes of a list of these records: the records, each with the header of an element. */
export function recordListSize(records: readonly Uint8Array[]): number {
  let size = 0;
  for (let i = 0; i < records.length; i++) {
    const { length } = records[i]!;
    size += 1 + varintSize(length) + length;
  }
  return size;
}

/** Bytes that `writeListHeader` writes for a list of this size. */
export function listHeaderSize(listSize: number): number {
  return 1 + varintSize(listSize);
}

/**
 * Writes what comes before the first element of a `TopicData` with `topic_data_record_list`. Only for
 * clients that asked for lists. [TD-4]
 *
 * @returns the position after it, where the first element belongs
 */
export function writeListHeader(target: Uint8Array, start: number, listSize: number): number {
  target[start] = LIST_TAG;
  return writeVarint(target, start + 1, listSize);
}

/**
 * Writes what comes before a record as an element of a list.
 *
 * @returns the position after it, where the record belongs
 */
export function writeElementHeader(
  target: Uint8Array,
  start: number,
  recordLength: number,
): number {
  target[start] = LIST_ELEMENT_TAG;
  return writeVarint(target, start + 1, recordLength);
}

/**
 * A frame with a list of encoded records, in their order: `TopicData` with `topic_data_record_list`.
 * Only for clients that asked for lists. [TD-4]
 */
export function encodeRecordListFrame(records: readonly Uint8Array[]): Uint8Array {
  const listSize = recordListSize(records);
  const frame = new Uint8Array(listHeaderSize(listSize) + listSize);
  let pos = writeListHeader(frame, 0, listSize);
  for (const record of records) {
    pos = writeElementHeader(frame, pos, record.length);
    frame.set(record, pos);
    pos += record.length;
  }
  return frame;
}

/** A frame with an error: `TopicData` with `error`. [TD-17] */
export function encodeErrorFrame(error: Init<ErrorMessage>): Uint8Array {
  return writeMessage((message: Init<ErrorMessage>, writer) => {
    const opened = writer.open(ERROR_TAG);
    encodeErrorMessage(message, writer);
    writer.close(opened);
  }, error);
}

/** A frame with a message between the master and a node: `TopicData` with `node_message`. [EX-20] */
export function encodeNodeMessageFrame(message: Init<NodeMessage>): Uint8Array {
  return writeMessage((content: Init<NodeMessage>, writer) => {
    const opened = writer.open(NODE_MESSAGE_TAG);
    encodeNodeMessage(content, writer);
    writer.close(opened);
  }, message);
}
