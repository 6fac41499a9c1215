import { decode, encode, fromJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { JoinedMessage, splitMessage } from './decode-messages.ts';

function passed(message: object): unknown {
  const joined = new JoinedMessage();
  for (const piece of splitMessage(message)) joined.add(structuredClone(piece));
  return joined.message;
}

describe('a message in pieces [SV-44]', () => {
  it('is the same afterwards, absent members and lists in lists included', () => {
    const request = fromJson('ubii.services.ServiceRequest', {
      topic: '/services/session/runtime/add',
      session: {
        name: 'x'.repeat(600_000),
        tags: Array.from({ length: 3_000 }, (_, i) => `${i}`),
        processingModules: Array.from({ length: 300 }, (_, i) => ({
          name: `${i}`,
          tags: Array.from({ length: i === 7 ? 2_000 : 2 }, () => 'tag'),
          inputs: [{ internalName: 'in', messageFormat: 'double' }],
        })),
      },
    });
    expect(passed(request)).toStrictEqual(request);
    expect(Object.keys(passed(request) as object)).toEqual(Object.keys(request));
    expect(splitMessage(request).length).toBeGreaterThan(10);
  });

  it('has bytes of its own', () => {
    const bytes = encode('ubii.topicData.TopicDataRecord', {
      topic: '/t',
      image2D: { data: Uint8Array.of(1, 2, 3) },
    });
    const record = decode('ubii.topicData.TopicDataRecord', bytes);
    const [piece] = splitMessage({ image: record.image2D?.data });
    expect((piece!.values[0] as Uint8Array).buffer.byteLength).toBe(3);
    expect(passed(record)).toStrictEqual(record);
  });

  it('is one piece when it is small', () => {
    expect(splitMessage({ topic: '/a', list: [1, { b: 2 }] })).toHaveLength(1);
    expect(splitMessage({})).toEqual([]);
    expect(passed({})).toEqual({});
  });
});
