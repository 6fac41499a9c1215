import { describe, expect, it } from 'vitest';
import { decode, encode } from '../codec.ts';
import { messageDescriptor } from '../descriptor.ts';
import { encodeRecord } from '../records.ts';
import {
  encodeErrorFrame,
  encodeNodeMessageFrame,
  encodeRecordListFrame,
  listHeaderSize,
  recordFrameHeader,
  recordHeaderSize,
  recordListSize,
  writeElementHeader,
  writeListHeader,
  writeRecordHeader,
} from './frames.ts';
import * as tags from './tags.ts';

const FRAME = 'ubii.topicData.TopicData';

function recordOfLength(textLength: number): Uint8Array {
  return encodeRecord({ topic: '/t', format: 'string', value: 'x'.repeat(textLength) });
}

describe('the frames', () => {
  it.each([0, 100, 128, 16_000, 17_000, 3_000_000])(
    '[TD-3] header and record make a TopicData, record of %i characters',
    (textLength) => {
      const record = recordOfLength(textLength);
      const header = recordFrameHeader(record.length);
      const frame = new Uint8Array(header.length + record.length);
      frame.set(header);
      frame.set(record, header.length);
      expect(decode(FRAME, frame)).toEqual({
        topicDataRecord: decode('ubii.topicData.TopicDataRecord', record),
      });
    },
  );

  it.each([[[1]], [[1, 2, 3]], [[0, 127, 128, 20_000]], [[2_100_000, 1]]])(
    '[TD-4] a list keeps its records in order, records of %j characters',
    (lengths) => {
      const records = lengths.map(recordOfLength);
      expect(decode(FRAME, encodeRecordListFrame(records))).toEqual({
        topicDataRecordList: {
          elements: records.map((record) => decode('ubii.topicData.TopicDataRecord', record)),
        },
      });
    },
  );

  it.each([0, 127, 128, 16_383, 16_384, 3_000_000])(
    'can be put together in place, records of %i bytes',
    (length) => {
      const target = new Uint8Array(20);
      for (const [write, size] of [
        [writeRecordHeader, recordHeaderSize],
        [writeListHeader, listHeaderSize],
        [writeElementHeader, recordHeaderSize],
      ] as const) {
        expect(write(target, 3, length)).toBe(3 + size(length));
      }
      expect(recordListSize([new Uint8Array(length)])).toBe(recordHeaderSize(length) + length);
    },
  );

  it('[TD-17] an error is a TopicData with error', () => {
    const error = { title: 't', message: 'm', stack: '', code: 'permission_denied', problems: [] };
    expect(decode(FRAME, encodeErrorFrame(error))).toEqual({ error });
  });

  it.each([0, 200, 20_000])(
    '[EX-20] a node message is a TopicData with node_message, record of %i characters',
    (textLength) => {
      const nodeMessage = {
        lockstepRequest: {
          pass: 7,
          sessionId: 's',
          processingModuleIds: ['m'],
          records: [{ topic: '/t', string: 'x'.repeat(textLength) }],
        },
      };
      const frame = encodeNodeMessageFrame(nodeMessage);
      expect(frame).toEqual(encode(FRAME, { nodeMessage }));
      expect(decode(FRAME, frame)).toMatchObject({ nodeMessage });
    },
  );

  it('have lengths of 1 to 5 bytes', () => {
    expect(
      [0x7f, 0x80, 0x3fff, 0x4000, 0x1f_ffff, 0x20_0000, 0xfff_ffff, 0x1000_0000].map(
        (length) => recordFrameHeader(length).length,
      ),
    ).toEqual([2, 3, 3, 4, 4, 5, 5, 6]);
  });

  it('use the tags of the schema', () => {
    const tag = (type: string, member: string): number =>
      (messageDescriptor(type).fieldByName.get(member)!.number << 3) | 2;
    expect(tag(FRAME, 'topicDataRecord')).toBe(tags.RECORD_TAG);
    expect(tag(FRAME, 'topicDataRecordList')).toBe(tags.LIST_TAG);
    expect(tag(FRAME, 'error')).toBe(tags.ERROR_TAG);
    expect(tag(FRAME, 'nodeMessage')).toBe(tags.NODE_MESSAGE_TAG);
    expect(tag('ubii.topicData.TopicDataRecordList', 'elements')).toBe(tags.LIST_ELEMENT_TAG);
    expect(tag('ubii.topicData.TopicDataRecord', 'topic')).toBe(tags.TOPIC_TAG);
    expect(tag('ubii.topicData.TopicDataRecord', 'timestamp')).toBe(tags.TIMESTAMP_TAG);
    expect(tag('ubii.topicData.TopicDataRecord', 'clientId')).toBe(tags.CLIENT_ID_TAG);
    expect(tag('ubii.topicData.TopicDataRecord', 'extension')).toBe(tags.RECORD_EXTENSION_TAG);
    expect(tag('ubii.extension.RecordExtension', 'keepSeconds')).toBe(tags.KEEP_SECONDS_TAG | 2);
    expect(tag('ubii.extension.RecordExtension', 'expiryMs')).toBe(tags.EXPIRY_MS_TAG | 2);
  });
});
