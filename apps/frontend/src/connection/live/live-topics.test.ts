import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { joinStatus, nextStatus, type LiveStatus } from './live-status.ts';
import { LiveTopics } from './live-topics.ts';
import { MAX_TOPICS, type RecordView } from './record-window.ts';
import { patternKey, patternRateHz, type LivePattern } from './topic-source.ts';

const FRAME_MS = 16;

interface Told {
  readonly topic: string;
  readonly value: number;
  readonly timestampMs?: number;
}

/** Creates live topics on a fake master that retains the newest record of each topic. */
function setUp(keep = 1) {
  const clock = new FakeClock();
  const retained = new Map<string, Told>();
  const open = new Map<object, { pattern: LivePattern; onRecord: (record: Told) => void }>();
  const log: string[] = [];
  const statuses: LiveStatus[] = [];
  const heard: number[] = [];
  const views: RecordView<Told>[] = [];
  let reply: Promise<void> = Promise.resolve();
  const selects = (pattern: LivePattern, topic: string): boolean =>
    patternKey(pattern) === `topic ${topic}` || patternKey(pattern).startsWith('glob ');
  const live = new LiveTopics<Told>(keep, {
    subscribe(pattern, onRecord) {
      const subscription = { ready: reply, close: () => close(subscription) };
      open.set(subscription, { pattern, onRecord });
      log.push(`+${nameOf(pattern)}`);
      for (const record of retained.values()) {
        if (selects(pattern, record.topic)) clock.after(1, () => onRecord(record));
      }
      return subscription;
    },
    atFrame: (fn) => void clock.after(FRAME_MS, fn),
    onRecord: ({ value }) => heard.push(value),
    show: (view) => views.push(view),
    showStatus: (status) => statuses.at(-1) === status || statuses.push(status),
  });
  function close(subscription: object): void {
    log.push(`-${nameOf(open.get(subscription)!.pattern)}`);
    open.delete(subscription);
  }
  function publish(topic: string, value: number, timestampMs?: number): void {
    const record = { topic, value, ...(timestampMs === undefined ? {} : { timestampMs }) };
    retained.set(topic, record);
    for (const { pattern, onRecord } of open.values()) {
      if (selects(pattern, topic)) onRecord(record);
    }
  }
  return {
    clock,
    live,
    log,
    heard,
    views,
    statuses,
    open,
    publish,
    frame: () => clock.advanceSync(FRAME_MS),
    last: () => views.at(-1),
    answer: (next: Promise<void>) => void (reply = next),
  };
}

const nameOf = (pattern: LivePattern): string =>
  `${patternKey(pattern)}${patternRateHz(pattern) === undefined ? '' : ` ${patternRateHz(pattern)} Hz`}`;

describe('live topics', () => {
  it('show a retained record in the frame after it came', () => {
    const { live, publish, clock, frame, last } = setUp();
    publish('/a', 7);
    live.follow(['/a']);
    clock.advanceSync(1);
    frame();
    expect(last()).toMatchObject({ newest: { value: 7 }, received: 1, dropped: 0 });
  });

  it('cost one update a frame, and count records that were not drawn', () => {
    const { live, publish, frame, views, heard } = setUp();
    live.follow(['/a']);
    for (let value = 1; value <= 50; value++) publish('/a', value);
    frame();
    publish('/a', 51);
    frame();
    expect(views.map(({ newest }) => newest?.value)).toEqual([50, 51]);
    expect(views.at(-1)).toMatchObject({ received: 51, dropped: 49 });
    expect(heard).toHaveLength(51);
  });

  it('keep the last records, oldest first, and count only those that left unseen', () => {
    const { live, publish, frame, last } = setUp(3);
    live.follow(['/a']);
    for (const value of [1, 2, 3]) publish('/a', value);
    frame();
    for (const value of [4, 5, 6, 7]) publish('/a', value);
    frame();
    expect(last()?.records.map(({ value }) => value)).toEqual([5, 6, 7]);
    expect(last()?.dropped).toBe(1);
  });

  it('keep the newest record of each topic of a pattern, of a bounded number of topics', () => {
    const { live, publish, frame, last } = setUp();
    live.follow([{ glob: '/**' }]);
    publish('/a', 1);
    publish('/b', 2);
    publish('/a', 3);
    frame();
    expect([...last()!.byTopic.values()].map(({ value }) => value)).toEqual([3, 2]);
    expect(last()?.newest?.value).toBe(3);
    for (let index = 0; index < MAX_TOPICS; index++) publish(`/${index}`, index);
    frame();
    expect(last()?.byTopic.size).toBe(MAX_TOPICS);
    expect(last()?.dropped).toBe(3);
  });

  it('follow another topic and forget the one before at once', () => {
    const { live, publish, frame, last, log } = setUp();
    live.follow(['/a', '/b']);
    publish('/a', 1);
    publish('/b', 2);
    frame();
    live.follow(['/b', '/c']);
    expect(log).toEqual(['+topic /a', '+topic /b', '-topic /a', '+topic /c']);
    expect([...last()!.byTopic.keys()]).toEqual(['/b']);
    live.follow([]);
    expect(last()?.newest).toBeUndefined();
  });

  it('take another rate without losing what they have', () => {
    const { live, publish, frame, last, log } = setUp();
    live.follow(['/a']);
    publish('/a', 1);
    frame();
    live.follow([{ topic: '/a', maxRateHz: 2 }]);
    expect(log).toEqual(['+topic /a', '+topic /a 2 Hz', '-topic /a']);
    frame();
    expect(last()?.newest?.value).toBe(1);
  });

  it('rest while they are not seen, and keep what they have', () => {
    const { live, publish, frame, last, open, statuses } = setUp(5);
    live.follow(['/a']);
    publish('/a', 1, 1000);
    frame();
    live.setSeen(false);
    expect(open.size).toBe(0);
    publish('/a', 2, 2000);
    live.setSeen(true);
    frame();
    frame();
    expect(last()?.records.map(({ value }) => value)).toEqual([1, 2]);
    expect(statuses).toEqual(['asking', 'off', 'asking']);
  });

  it('take a record once that the master sends again', () => {
    const { live, publish, frame, last, heard } = setUp(5);
    live.follow(['/a']);
    publish('/a', 1, 1000);
    live.setSeen(false);
    live.setSeen(true);
    frame();
    live.expectRepeats();
    publish('/a', 1, 1000);
    frame();
    expect(heard).toEqual([1]);
    // A later record with the same timestamp is a different one.
    publish('/a', 2, 1000);
    frame();
    expect(last()?.records.map(({ value }) => value)).toEqual([1, 2]);
  });

  it('draw nothing where each record is taken as it comes', () => {
    const { live, publish, clock, views, heard } = setUp(0);
    live.follow(['/a']);
    publish('/a', 1);
    publish('/a', 2);
    expect(heard).toEqual([1, 2]);
    expect(clock.timerCount).toBe(0);
    expect(views).toEqual([]);
  });

  it('give everything back when they are closed, and draw no frame after that', () => {
    const { live, publish, frame, views, open } = setUp();
    live.follow(['/a', { glob: '/b/*' }]);
    publish('/a', 1);
    live.close();
    frame();
    live.setSeen(true);
    expect(open.size).toBe(0);
    expect(views).toEqual([]);
  });

  it('tell whether the master accepted or refused them', async () => {
    const { live, clock, statuses, answer } = setUp();
    live.follow(['/a']);
    await clock.advance(0);
    answer(Promise.reject(new Error('Not for you.')));
    live.follow(['/b']);
    await clock.advance(0);
    live.follow([]);
    expect(statuses).toEqual(['asking', 'live', 'asking', 'refused', 'off']);
  });
});

describe('the status of a subscription', () => {
  it('ignores a reply that comes after its end', () => {
    expect(nextStatus('off', 'accept')).toBe('off');
    expect(nextStatus('off', 'refuse')).toBe('off');
  });

  it('of several is the one that tells most', () => {
    expect(joinStatus([])).toBe('off');
    expect(joinStatus(['live', 'asking'])).toBe('asking');
    expect(joinStatus(['live', 'refused', 'asking'])).toBe('refused');
  });
});
