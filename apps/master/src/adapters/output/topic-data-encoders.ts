import {
  listHeaderSize,
  recordHeaderSize,
  recordListSize,
  writeElementHeader,
  writeListHeader,
  writeRecordHeader,
} from '@ubii/proto/wire';

import type { BatchEncoder } from '../../core/ports/index.ts';
import { JoinedParts, joinedSize, type FrameParts } from './joined-parts.ts';

/** Makes the messages of a batch. */
export type TopicDataEncoder = BatchEncoder<FrameParts>;

/** What a protocol writes before the content of a message with `TopicData`. */
export interface MessageHead {
  /** Returns its size for a content of this size, bytes. */
  size(contentBytes: number): number;
  /** Writes it, and returns the position after it, where the content belongs. */
  write(target: Buffer, start: number, contentBytes: number): number;
}

/** One message for each record. [TD-3] */
export function singleRecordEncoder(head: MessageHead): TopicDataEncoder {
  return {
    encode({ records }) {
      let size = 0;
      for (let i = 0; i < records.length; i++) {
        const { length } = records[i]!;
        const contentBytes = recordHeaderSize(length) + length;
        size += head.size(contentBytes) + recordHeaderSize(length) + joinedSize(length);
      }
      const parts = new JoinedParts(size);
      for (let i = 0; i < records.length; i++) {
        const record = records[i]!;
        const { length } = record;
        parts.pos = head.write(parts.bytes, parts.pos, recordHeaderSize(length) + length);
        parts.pos = writeRecordHeader(parts.bytes, parts.pos, length);
        parts.add(record);
      }
      return parts.finish();
    },
  };
}

/** One message for all records. [TD-4] */
export function recordListEncoder(head: MessageHead): TopicDataEncoder {
  return {
    encode({ records }) {
      const listSize = recordListSize(records);
      const contentBytes = listHeaderSize(listSize) + listSize;
      let size = head.size(contentBytes) + contentBytes;
      for (let i = 0; i < records.length; i++) {
        const { length } = records[i]!;
        size -= length - joinedSize(length);
      }
      const parts = new JoinedParts(size);
      parts.pos = head.write(parts.bytes, parts.pos, contentBytes);
      parts.pos = writeListHeader(parts.bytes, parts.pos, listSize);
      for (let i = 0; i < records.length; i++) {
        const record = records[i]!;
        parts.pos = writeElementHeader(parts.bytes, parts.pos, record.length);
        parts.add(record);
      }
      return parts.finish();
    },
  };
}
