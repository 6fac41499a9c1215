import { Reader } from '../binary/reader.ts';
import { skipField } from '../binary/skip-field.ts';
import { varintSize, writeVarint } from '../binary/varint.ts';
import { decode, encode } from '../codec.ts';
import { DecodeError } from '../decode-error.ts';
import type {
  BridgeAnswer,
  BridgeOrder,
  EndedTopics,
  LockstepProcessingReply,
  LockstepProcessingRequest,
  ModuleReports,
  NodeRecorderAnswer,
  NodeRecorderOrder,
  NodeRecorderReport,
} from '../generated/messages.ts';
import type { Init } from '../init.ts';
import {
  BRIDGE_ANSWER_TAG,
  BRIDGE_ORDER_TAG,
  ENDED_TOPICS_TAG,
  LOCKSTEP_RECORD_TAG,
  LOCKSTEP_REPLY_TAG,
  LOCKSTEP_REQUEST_TAG,
  MODULE_REPORTS_TAG,
  NODE_MESSAGE_TAG,
  RECORDER_ANSWER_TAG,
  RECORDER_ORDER_TAG,
  RECORDER_REPORT_TAG,
} from './tags.ts';

/** One side of a lockstep pass, its records as they travel. */
export interface LockstepMessage<M> {
  /** Everything but the records; `records` in it is empty. */
  readonly head: M;
  /** Encoded `TopicDataRecord`s, views of the message. */
  readonly records: readonly Uint8Array[];
}

/** Content of a `NodeMessage`; records stay encoded. */
export interface EncodedNodeMessage {
  readonly lockstepRequest?: LockstepMessage<LockstepProcessingRequest>;
  readonly lockstepReply?: LockstepMessage<LockstepProcessingReply>;
  readonly moduleReports?: ModuleReports;
  readonly endedTopics?: EndedTopics;
  readonly recorderOrder?: NodeRecorderOrder;
  readonly recorderAnswer?: NodeRecorderAnswer;
  readonly recorderReport?: NodeRecorderReport;
  readonly bridgeOrder?: BridgeOrder;
  readonly bridgeAnswer?: BridgeAnswer;
}

const NODE_MESSAGE = 'ubii.extension.NodeMessage';
const REQUEST = 'ubii.processing.LockstepProcessingRequest';
const REPLY = 'ubii.processing.LockstepProcessingReply';

/** Members without records, which are decoded as they are. */
const DECODED: { readonly [tag: number]: (bytes: Uint8Array) => EncodedNodeMessage } = {
  [MODULE_REPORTS_TAG]: (bytes) => ({
    moduleReports: decode('ubii.extension.ModuleReports', bytes),
  }),
  [ENDED_TOPICS_TAG]: (bytes) => ({ endedTopics: decode('ubii.extension.EndedTopics', bytes) }),
  [RECORDER_ORDER_TAG]: (bytes) => ({
    recorderOrder: decode('ubii.extension.NodeRecorderOrder', bytes),
  }),
  [RECORDER_ANSWER_TAG]: (bytes) => ({
    recorderAnswer: decode('ubii.extension.NodeRecorderAnswer', bytes),
  }),
  [RECORDER_REPORT_TAG]: (bytes) => ({
    recorderReport: decode('ubii.extension.NodeRecorderReport', bytes),
  }),
  [BRIDGE_ORDER_TAG]: (bytes) => ({ bridgeOrder: decode('ubii.extension.BridgeOrder', bytes) }),
  [BRIDGE_ANSWER_TAG]: (bytes) => ({ bridgeAnswer: decode('ubii.extension.BridgeAnswer', bytes) }),
};

/** A frame that asks a node for its share of a lockstep pass. [SE-40] */
export function encodeLockstepRequestFrame(
  head: Init<LockstepProcessingRequest>,
  records: readonly Uint8Array[],
): Uint8Array {
  return lockstepFrame(LOCKSTEP_REQUEST_TAG, encode(REQUEST, head), records);
}

/** A frame with what a node put out in a lockstep pass. [SE-41] */
export function encodeLockstepReplyFrame(
  head: Init<LockstepProcessingReply>,
  records: readonly Uint8Array[],
): Uint8Array {
  return lockstepFrame(LOCKSTEP_REPLY_TAG, encode(REPLY, head), records);
}

/**
 * Reads a `NodeMessage` without decoding the records in it.
 *
 * @param borrowedBytes the records of the result are views of it
 * @throws DecodeError when it is none
 */
export function readNodeMessage(borrowedBytes: Uint8Array): EncodedNodeMessage {
  const reader = new Reader(borrowedBytes);
  let result: EncodedNodeMessage = {};
  try {
    while (reader.pos < reader.end) {
      const tag = reader.tag();
      // Of a oneof the last one counts.
      if (tag === LOCKSTEP_REQUEST_TAG) result = { lockstepRequest: readLockstep(reader, REQUEST) };
      else if (tag === LOCKSTEP_REPLY_TAG) result = { lockstepReply: readLockstep(reader, REPLY) };
      else {
        const read = DECODED[tag];
        if (read === undefined) skipField(reader, tag);
        else result = read(reader.bytes());
      }
    }
  } catch (cause) {
    throw DecodeError.wrap(NODE_MESSAGE, borrowedBytes.length, cause);
  }
  return result;
}

function readLockstep<T extends typeof REQUEST | typeof REPLY>(reader: Reader, type: T) {
  const outerEnd = reader.enter();
  const records: Uint8Array[] = [];
  const others: Uint8Array[] = [];
  while (reader.pos < reader.end) {
    const start = reader.pos;
    const tag = reader.tag();
    if (tag === LOCKSTEP_RECORD_TAG) {
      records.push(reader.bytes());
    } else {
      skipField(reader, tag);
      others.push(reader.input.subarray(start, reader.pos));
    }
  }
  reader.end = outerEnd;
  return { head: decode(type, joined(others)), records };
}

/** Fields of a message may come in any order, so the records are appended to the encoded rest. */
function lockstepFrame(tag: number, head: Uint8Array, records: readonly Uint8Array[]): Uint8Array {
  let bodySize = head.length;
  for (const { length } of records) bodySize += 1 + varintSize(length) + length;
  const messageSize = 1 + varintSize(bodySize) + bodySize;
  const frame = new Uint8Array(
    varintSize(NODE_MESSAGE_TAG) + varintSize(messageSize) + messageSize,
  );
  let pos = writeVarint(frame, 0, NODE_MESSAGE_TAG);
  pos = writeVarint(frame, pos, messageSize);
  frame[pos] = tag;
  pos = writeVarint(frame, pos + 1, bodySize);
  frame.set(head, pos);
  pos += head.length;
  for (const record of records) {
    frame[pos] = LOCKSTEP_RECORD_TAG;
    pos = writeVarint(frame, pos + 1, record.length);
    frame.set(record, pos);
    pos += record.length;
  }
  return frame;
}

function joined(parts: readonly Uint8Array[]): Uint8Array {
  const bytes = new Uint8Array(parts.reduce((size, { length }) => size + length, 0));
  let pos = 0;
  for (const part of parts) {
    bytes.set(part, pos);
    pos += part.length;
  }
  return bytes;
}
