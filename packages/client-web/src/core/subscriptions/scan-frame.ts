import { ServiceError, decode } from '@ubii/proto';
import { TextCache, readNodeMessage, scanTopicData } from '@ubii/proto/wire';
import type { EncodedNodeMessage } from '@ubii/proto/wire';
import { ReceivedRecord } from './received-record.ts';

/** From this size a buffer is worth transferring instead of copying, bytes. */
export const TRANSFERABLE_BYTES = 16 * 1024;

/** Content of a frame, with encoded records. */
export interface ScannedFrame {
  readonly records: readonly ReceivedRecord[];
  readonly errors: readonly ServiceError[];
  readonly nodeMessages: readonly EncodedNodeMessage[];
}

interface Bounds {
  readonly topic: string;
  readonly start: number;
  readonly end: number;
  readonly valueField: number;
}

/** Topics come with every record. */
const topics = new TextCache();

/**
 * Takes a frame apart without decoding its records. A large record stays where it is, so that its
 * bytes are not copied; the frame's buffer goes with it when it is the only one. Small records beside
 * others are copied, so that a kept record does not keep the frame.
 *
 * @param keptFrame must not be changed later
 * @throws DecodeError when anything in it is broken
 */
export function scanFrame(keptFrame: Uint8Array): ScannedFrame {
  const found: Bounds[] = [];
  const errors: ServiceError[] = [];
  const nodeMessages: EncodedNodeMessage[] = [];
  scanTopicData(
    keptFrame,
    {
      record: (topic, start, end, valueField) => void found.push({ topic, start, end, valueField }),
      error: (start, end) => {
        const error = decode('ubii.general.Error', keptFrame.subarray(start, end));
        errors.push(ServiceError.fromWire(error));
      },
      nodeMessage: (start, end) =>
        void nodeMessages.push(readNodeMessage(keptFrame.subarray(start, end))),
    },
    topics,
  );
  const largeCount = found.filter(isLarge).length;
  const ownsBuffer = largeCount === 1 && nodeMessages.length === 0 && holdsWholeBuffer(keptFrame);
  const records = found.map((bounds) => {
    const { topic, start, end, valueField } = bounds;
    const stays = isLarge(bounds) || found.length === 1;
    const bytes = stays ? keptFrame.subarray(start, end) : keptFrame.slice(start, end);
    return ReceivedRecord.fromEncoded(topic, bytes, valueField, ownsBuffer && isLarge(bounds));
  });
  return { records, errors, nodeMessages };
}

function isLarge({ start, end }: Bounds): boolean {
  return end - start >= TRANSFERABLE_BYTES;
}

/** A frame that is a part of a larger buffer has no right to give that away. */
function holdsWholeBuffer({ byteOffset, byteLength, buffer }: Uint8Array): boolean {
  return byteOffset === 0 && byteLength === buffer.byteLength && buffer instanceof ArrayBuffer;
}
