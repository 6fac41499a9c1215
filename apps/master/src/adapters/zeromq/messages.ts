import {
  encodeErrorFrame,
  listHeaderSize,
  recordHeaderSize,
  recordListSize,
  writeElementHeader,
  writeListHeader,
  writeRecordHeader,
} from '@ubii/proto/wire';
import type { ErrorMessage } from '@ubii/proto';

import type { BatchEncoder } from '../../core/ports/index.ts';
import { JoinedParts, joinedSize, type FrameParts } from '../output/joined-parts.ts';
import { DELIMITER, encodeFrame, frameHeaderSize, writeFrameHeader } from './zmtp-frames.ts';

/*
 * Messages from a ROUTER to a DEALER, as existing clients expect them: an empty frame, then the content. [TD-50]
 */

/** Makes the messages of a batch. */
export type MessageEncoder = BatchEncoder<FrameParts>;

/** One message for each record. [TD-3] */
export const singleMessages: MessageEncoder = {
  encode({ records }) {
    let size = 0;
    for (let i = 0; i < records.length; i++) {
      const { length } = records[i]!;
      size += messageHeadSize(recordHeaderSize(length) + length) + recordHeaderSize(length);
      size += joinedSize(length);
    }
    const parts = new JoinedParts(size);
    for (let i = 0; i < records.length; i++) {
      const record = records[i]!;
      const { length } = record;
      parts.pos = writeMessageHead(parts.bytes, parts.pos, recordHeaderSize(length) + length);
      parts.pos = writeRecordHeader(parts.bytes, parts.pos, length);
      parts.add(record);
    }
    return parts.finish();
  },
};

/** One message for all records. [TD-4] */
export const listMessages: MessageEncoder = {
  encode({ records }) {
    const listSize = recordListSize(records);
    const contentBytes = listHeaderSize(listSize) + listSize;
    let size = messageHeadSize(contentBytes) + contentBytes;
    for (let i = 0; i < records.length; i++) {
      const { length } = records[i]!;
      size -= length - joinedSize(length);
    }
    const parts = new JoinedParts(size);
    parts.pos = writeMessageHead(parts.bytes, parts.pos, contentBytes);
    parts.pos = writeListHeader(parts.bytes, parts.pos, listSize);
    for (let i = 0; i < records.length; i++) {
      const record = records[i]!;
      parts.pos = writeElementHeader(parts.bytes, parts.pos, record.length);
      parts.add(record);
    }
    return parts.finish();
  },
};

/** A message with an encoded `TopicData`. */
export function topicDataMessage(content: Uint8Array): FrameParts {
  return [DELIMITER, encodeFrame(content)];
}

/** A message with an error. [TD-17] */
export function errorMessage(error: ErrorMessage): FrameParts {
  return topicDataMessage(encodeErrorFrame(error));
}

/** A message with a heartbeat. @param text ASCII */
export function textMessage(text: string): FrameParts {
  return topicDataMessage(Buffer.from(text, 'latin1'));
}

function messageHeadSize(contentBytes: number): number {
  return DELIMITER.length + frameHeaderSize(contentBytes);
}

/** Returns the position of the content. */
function writeMessageHead(target: Buffer, start: number, contentBytes: number): number {
  target.set(DELIMITER, start);
  return writeFrameHeader(target, start + DELIMITER.length, contentBytes);
}
