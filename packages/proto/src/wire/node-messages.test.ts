import { describe, expect, it } from 'vitest';
import { decode, encode } from '../codec.ts';
import { DecodeError } from '../decode-error.ts';
import { decodeTopicData, encodeRecord } from '../records.ts';
import { messageDescriptor } from '../descriptor.ts';
import { encodeNodeMessageFrame } from './frames.ts';
import {
  encodeLockstepReplyFrame,
  encodeLockstepRequestFrame,
  readNodeMessage,
} from './node-messages.ts';
import { scanTopicData } from './scan-topic-data.ts';
import * as tags from './tags.ts';

const records = [1, 200, 20_000].map((length) =>
  encodeRecord({ topic: '/t', format: 'string', value: 'x'.repeat(length) }),
);
const decoded = records.map((record) => decode('ubii.topicData.TopicDataRecord', record));
const request = { processingModuleIds: ['a', 'b'], pass: 7, sessionId: 's', deltaTime: 16.5 };
const reply = { processingModuleIds: ['a'], pass: 7, sessionId: 's' };

function messageOf(frame: Uint8Array): Uint8Array {
  let message: Uint8Array | undefined;
  scanTopicData(frame, {
    record: () => undefined,
    error: () => undefined,
    nodeMessage: (start, end) => (message = frame.subarray(start, end)),
  });
  return message!;
}

describe('node messages with encoded records', () => {
  it('[SE-40] a request is the frame that encoding it as a whole would give to a reader', () => {
    expect(decodeTopicData(encodeLockstepRequestFrame(request, records)).nodeMessages).toEqual(
      decodeTopicData(encodeNodeMessageFrame({ lockstepRequest: { ...request, records: decoded } }))
        .nodeMessages,
    );
  });

  it('[SE-41] and so is a reply, without records too', () => {
    for (const count of [0, 3]) {
      const frame = encodeLockstepReplyFrame(reply, records.slice(0, count));
      expect(decodeTopicData(frame).nodeMessages).toEqual(
        decodeTopicData(
          encodeNodeMessageFrame({ lockstepReply: { ...reply, records: decoded.slice(0, count) } }),
        ).nodeMessages,
      );
    }
  });

  it('are read with their records as they came', () => {
    const read = readNodeMessage(messageOf(encodeLockstepRequestFrame(request, records)));
    expect(read.lockstepRequest?.head).toMatchObject({ ...request, records: [] });
    expect(read.lockstepRequest?.records).toEqual(records);
    const answer = readNodeMessage(messageOf(encodeLockstepReplyFrame(reply, records)));
    expect(answer.lockstepReply?.head).toMatchObject(reply);
    expect(answer.lockstepReply?.records).toEqual(records);
  });

  it('are read whatever the order of their fields, and reports are decoded', () => {
    const frame = encodeNodeMessageFrame({ lockstepReply: { ...reply, records: decoded } });
    expect(readNodeMessage(messageOf(frame)).lockstepReply?.head).toMatchObject(reply);
    const moduleReports = { statistics: [{ moduleId: 'm', runs: 3 }], events: [] };
    expect(readNodeMessage(messageOf(encodeNodeMessageFrame({ moduleReports })))).toMatchObject({
      moduleReports,
    });
  });

  it('fail as a DecodeError when they are broken', () => {
    const bytes = encode('ubii.extension.NodeMessage', { lockstepRequest: request });
    expect(() => readNodeMessage(bytes.subarray(0, bytes.length - 3))).toThrow(DecodeError);
  });

  it('use the tags of the schema', () => {
    const tag = (type: string, member: string): number =>
      (messageDescriptor(type).fieldByName.get(member)!.number << 3) | 2;
    const message = 'ubii.extension.NodeMessage';
    expect(tag(message, 'lockstepRequest')).toBe(tags.LOCKSTEP_REQUEST_TAG);
    expect(tag(message, 'lockstepReply')).toBe(tags.LOCKSTEP_REPLY_TAG);
    expect(tag(message, 'moduleReports')).toBe(tags.MODULE_REPORTS_TAG);
    expect(tag(message, 'bridgeOrder')).toBe(tags.BRIDGE_ORDER_TAG);
    expect(tag(message, 'bridgeAnswer')).toBe(tags.BRIDGE_ANSWER_TAG);
    for (const side of ['Request', 'Reply']) {
      expect(tag(`ubii.processing.LockstepProcessing${side}`, 'records')).toBe(
        tags.LOCKSTEP_RECORD_TAG,
      );
    }
  });
});
