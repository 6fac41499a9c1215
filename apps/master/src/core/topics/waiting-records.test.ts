import { describe, expect, it } from 'vitest';
import { testAccount } from '../../testing/index.ts';
import { RESOURCE } from '../shares/resources.ts';
import { TopicEntry } from './topic-entry.ts';
import { WaitingRecords } from './waiting-records.ts';

const A = new TopicEntry('/a');
const B = new TopicEntry('/b');

function createQueue(maxBytes = 1000, maxEventsPerTopic = 3) {
  const dropped: string[] = [];
  const account = testAccount({ [RESOURCE.queueBytes]: maxBytes });
  const queue = new WaitingRecords({
    account,
    maxEventsPerTopic,
    onDropped: ({ topic }) => dropped.push(topic),
  });
  const state = (entry: TopicEntry, value: number) =>
    queue.push(entry, Uint8Array.of(value), false);
  const event = (entry: TopicEntry, value: number) => queue.push(entry, Uint8Array.of(value), true);
  const takeAll = (): string[] => {
    const taken: string[] = [];
    for (let next = queue.take(); next !== undefined; next = queue.take()) {
      taken.push(`${next.entry.topic} ${next.record[0]}`);
    }
    return taken;
  };
  return { queue, dropped, state, event, takeAll };
}

describe('WaitingRecords', () => {
  it('keeps of a state only the newest, in the place of the first [TD-31]', () => {
    const { state, takeAll, dropped } = createQueue();
    state(A, 1);
    state(B, 2);
    state(A, 3);
    state(A, 4);
    expect(takeAll()).toEqual(['/a 4', '/b 2']);
    expect(dropped).toEqual(['/a', '/a']);
  });

  it('keeps every event, in order [TD-31]', () => {
    const { event, takeAll, dropped } = createQueue();
    event(A, 1);
    event(A, 2);
    event(A, 3);
    expect(takeAll()).toEqual(['/a 1', '/a 2', '/a 3']);
    expect(dropped).toEqual([]);
  });

  it('drops the oldest event when there are too many [TD-31]', () => {
    const { event, takeAll, dropped } = createQueue();
    for (const value of [1, 2, 3, 4, 5]) event(A, value);
    expect(takeAll()).toEqual(['/a 3', '/a 4', '/a 5']);
    expect(dropped).toEqual(['/a', '/a']);
  });

  it('does not let a state replace an event, or overtake it [TD-15]', () => {
    const { event, state, takeAll } = createQueue();
    event(A, 1);
    state(A, 2);
    state(A, 3);
    expect(takeAll()).toEqual(['/a 1', '/a 3']);
  });

  it('alternates between topics, so that many events of one topic do not delay other topics', () => {
    const { event, state, takeAll } = createQueue();
    event(A, 1);
    event(A, 2);
    event(A, 3);
    state(B, 4);
    expect(takeAll()).toEqual(['/a 1', '/b 4', '/a 2', '/a 3']);
  });

  it('drops the oldest records when they take too many bytes [TD-32]', () => {
    const { queue, dropped } = createQueue(250);
    queue.push(A, new Uint8Array(100), true);
    queue.push(B, new Uint8Array(100), false);
    queue.push(A, new Uint8Array(100), true);
    expect(dropped).toEqual(['/a']);
    expect(queue.byteLength).toBe(200);
    expect(queue.count).toBe(2);
  });

  it('keeps a single record that is larger than the bound, for want of an older one [TD-32]', () => {
    const { queue, dropped } = createQueue(250);
    queue.push(A, new Uint8Array(300), false);
    expect(queue.count).toBe(1);
    queue.push(B, new Uint8Array(10), false);
    expect(dropped).toEqual(['/a']);
    expect(queue.byteLength).toBe(10);
  });

  it('counts bytes and records down to nothing', () => {
    const { queue, event, state, takeAll } = createQueue();
    for (const value of [1, 2, 3, 4, 5]) event(A, value);
    for (const value of [1, 2, 3]) state(B, value);
    takeAll();
    expect([queue.byteLength, queue.count]).toEqual([0, 0]);
    expect(queue.has(A)).toBe(false);
  });
});
