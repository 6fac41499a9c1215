import { encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { Counters } from '../counters/counters.ts';
import { DEFAULT_LIMITS } from '../limits/index.ts';
import { publishForeign, type ForeignContext } from './foreign-records.ts';
import { Publication } from './publication.ts';
import { RecordTap } from './record-tap.ts';
import { ReplayedTopics } from './replayed-topics.ts';
import { TopicTable } from './topic-table.ts';
import { liveRule, playFirst } from '../../testing/live-rule.ts';
import { testAccount } from '../../testing/test-account.ts';

/** A topic with one subscriber, and what that got. */
function createWorld() {
  const topics = new TopicTable([], 0, 10, testAccount());
  const replayed = new ReplayedTopics();
  const context: ForeignContext = {
    id: 'b',
    topics,
    replayed,
    limits: DEFAULT_LIMITS,
    counters: new Counters(),
    tap: new RecordTap(),
    kept: { handleReplaced: () => undefined } as unknown as ForeignContext['kept'],
  };
  const entry = topics.getOrCreate('/a');
  const got: Uint8Array[] = [];
  entry.areTargetsStale = false;
  const receiver = { deliver: (_entry: unknown, record: Uint8Array) => void got.push(record) };
  entry.targets = { direct: [receiver as never], sampled: [], ownDirect: 1, ownSampled: 0 };
  const publish = (value: number, stamp: number, masterId: string, isValue = false): void => {
    const publication = new Publication();
    publication.topic = '/a';
    publication.frame = encodeRecord({ topic: '/a', format: 'double', value });
    publication.end = publication.frame.byteLength;
    publication.valueField = 3;
    publishForeign(context, publication, { stamp, masterId, publisherId: 'p', isValue });
  };
  return { entry, got, replayed, publish };
}

describe('records of other masters', () => {
  it('[CU-12] become the value when their stamp is the greatest, and are delivered anyway', () => {
    const { entry, got, publish } = createWorld();
    publish(1, 5, 'a');
    publish(2, 4, 'c');
    expect(got).toHaveLength(2);
    expect([entry.stamp, entry.originId]).toEqual([5, 'a']);
    publish(3, 5, 'c');
    expect([entry.stamp, entry.originId]).toEqual([5, 'c']);
    publish(4, 5, 'a');
    expect(entry.originId).toBe('c');
  });

  it('[CU-7] are not delivered again as the value that stands', () => {
    const { got, publish } = createWorld();
    publish(1, 5, 'a');
    publish(1, 5, 'a', true);
    publish(2, 4, 'a', true);
    expect(got).toHaveLength(1);
  });

  it('[CU-15] are not delivered on a topic that a replay plays', () => {
    const { got, replayed, publish } = createWorld();
    const rule = liveRule();
    replayed.add('/a', rule);
    playFirst(replayed, '/a');
    publish(1, 5, 'a');
    expect(got).toHaveLength(0);
    replayed.remove(rule);
    publish(2, 6, 'a');
    expect(got).toHaveLength(1);
  });
});
