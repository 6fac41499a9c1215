import { decodeTopicData, encodeRecord } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { PUBLISH_LIMITS, PublishBuffer } from './publish-buffer.ts';

function setup(intervalMs = 15) {
  const clock = new FakeClock();
  const frames: string[][] = [];
  const sink = {
    isOpen: true,
    bufferedBytes: 0,
    send(frame: Uint8Array, recordCount: number) {
      const { records, failed } = decodeTopicData(frame);
      expect(failed).toEqual([]);
      expect(records).toHaveLength(recordCount);
      frames.push(records.map(({ topic, value }) => `${topic}=${String(value)}`));
    },
  };
  const buffer = new PublishBuffer(clock, sink, intervalMs);
  const add = (topic: string, value: number, options: { isEvent?: boolean; now?: boolean } = {}) =>
    buffer.add(
      {
        topic,
        bytes: encodeRecord({ topic, format: 'double', value }),
        isEvent: options.isEvent ?? false,
      },
      options.now ?? false,
    );
  return { clock, frames, sink, buffer, add };
}

describe('PublishBuffer while the socket takes everything', () => {
  it('sends the first record after a pause at the end of the turn', async () => {
    const { add, frames, clock } = setup(15);
    add('a', 1);
    expect(frames).toEqual([]);
    await clock.advance(0);
    expect(frames).toEqual([['a=1']]);
  });

  it('collects what follows for one interval, in the order of publishing', async () => {
    const { add, frames, clock } = setup(15);
    add('a', 1);
    await clock.advance(0);
    add('b', 1);
    await clock.advance(5);
    add('a', 2);
    add('b', 2);
    await clock.advance(9);
    expect(frames).toHaveLength(1);
    await clock.advance(1);
    expect(frames).toEqual([['a=1'], ['b=1', 'a=2', 'b=2']]);
  });

  it('sends an immediate record at once, after those that wait', async () => {
    const { add, frames, clock } = setup(15);
    add('a', 1);
    await clock.advance(0);
    add('a', 2);
    add('a', 3, { now: true });
    expect(frames).toEqual([['a=1'], ['a=2', 'a=3']]);
    await clock.advance(100);
    expect(frames).toHaveLength(2);
    expect(clock.timerCount).toBe(0);
  });

  it('splits what is large into several frames', async () => {
    const { buffer, frames, clock } = setup(0);
    const text = 'x'.repeat(100 * 1024);
    for (const topic of ['a', 'b', 'c', 'd', 'e']) {
      buffer.add(
        {
          topic,
          bytes: encodeRecord({ topic, format: 'string', value: text }),
          isEvent: false,
        },
        false,
      );
    }
    await clock.advance(0);
    expect(frames.map((frame) => frame.length)).toEqual([2, 2, 1]);
  });

  it('does not wait for the interval when very many records wait', () => {
    const { add, frames } = setup(1_000);
    for (let i = 0; i < PUBLISH_LIMITS.recordsAtOnce; i++) add('a', i);
    expect(frames.flat()).toHaveLength(PUBLISH_LIMITS.recordsAtOnce);
  });

  it('follows a change of the interval', async () => {
    const { add, frames, clock, buffer } = setup(1_000);
    add('a', 1);
    await clock.advance(0);
    add('a', 2);
    buffer.setIntervalMs(20);
    await clock.advance(20);
    expect(frames).toHaveLength(2);
  });

  it.each([-1, Number.NaN, Infinity])('refuses an interval of %s ms', (intervalMs) => {
    expect(() => setup(intervalMs)).toThrow(RangeError);
  });
});

describe('PublishBuffer while the socket is full', () => {
  function setupFull() {
    const all = setup(0);
    all.sink.bufferedBytes = PUBLISH_LIMITS.socketFullBytes + 1;
    return all;
  }

  it('keeps the newest value of each state and counts the others', async () => {
    const { add, frames, clock, sink, buffer } = setupFull();
    for (const n of [1, 2, 3]) {
      add('a', n);
      add('b', n);
      await clock.advance(20);
    }
    expect(frames).toEqual([]);
    sink.bufferedBytes = 0;
    await clock.advance(PUBLISH_LIMITS.socketPollMs);
    expect(frames).toEqual([['a=3', 'b=3']]);
    expect(buffer.dropped).toBe(4);
  });

  it('keeps one picture of a camera, the newest, whether the socket is full or away', async () => {
    const { buffer, clock, sink, frames } = setupFull();
    const picture = (number: number) =>
      encodeRecord({
        topic: 'camera',
        format: 'string',
        value: `${number} ${'x'.repeat(100_000)}`,
      });
    for (let n = 0; n < 100; n++) {
      sink.isOpen = n < 50;
      buffer.add({ topic: 'camera', bytes: picture(n), isEvent: false }, false);
      await clock.advance(33);
      expect(buffer.waitingBytes).toBe(picture(n).byteLength);
    }
    expect(buffer.dropped).toBe(99);
    sink.isOpen = true;
    sink.bufferedBytes = 0;
    buffer.flush();
    expect(frames.map(([record]) => record!.slice(0, 9))).toEqual(['camera=99']);
    expect(buffer.waitingBytes).toBe(0);
  });

  it('keeps events, in their order, up to the bound', async () => {
    const { add, frames, clock, sink, buffer } = setupFull();
    const bound = PUBLISH_LIMITS.waitingEventsPerTopic;
    for (let n = 0; n < bound + 2; n++) add('e', n, { isEvent: true });
    await clock.advance(20);
    sink.bufferedBytes = 0;
    await clock.advance(PUBLISH_LIMITS.socketPollMs);
    expect(frames.flat()).toEqual(Array.from({ length: bound }, (_, i) => `e=${i + 2}`));
    expect(buffer.dropped).toBe(2);
  });

  it('goes on sending while the socket fills in between', async () => {
    const { buffer, frames, clock, sink } = setup(0);
    const text = 'x'.repeat(PUBLISH_LIMITS.frameBytes);
    const send = sink.send.bind(sink);
    sink.send = (frame, count) => {
      send(frame, count);
      sink.bufferedBytes += frame.byteLength;
    };
    for (const topic of ['a', 'b', 'c', 'd']) {
      buffer.add(
        { topic, bytes: encodeRecord({ topic, format: 'string', value: text }), isEvent: false },
        false,
      );
    }
    await clock.advance(0);
    expect(frames).toHaveLength(2);
    sink.bufferedBytes = 0;
    await clock.advance(PUBLISH_LIMITS.socketPollMs);
    expect(frames).toHaveLength(4);
    expect(buffer.dropped).toBe(0);
  });
});

describe('PublishBuffer without a connection', () => {
  function setupAway() {
    const all = setup(0);
    all.sink.isOpen = false;
    return all;
  }

  it('keeps the newest record of each topic, events too, for the next flush', async () => {
    const { add, frames, clock, sink, buffer } = setupAway();
    add('a', 1);
    add('e', 1, { isEvent: true });
    await clock.advance(0);
    add('a', 2);
    add('e', 2, { isEvent: true });
    await clock.advance(1_000);
    sink.isOpen = true;
    buffer.flush();
    expect(frames).toEqual([['a=2', 'e=2']]);
    expect(buffer.dropped).toBe(2);
  });

  it('keeps a bounded number of topics, the newest', async () => {
    const { add, frames, clock, sink, buffer } = setupAway();
    for (let i = 0; i < PUBLISH_LIMITS.awayTopics + 5; i++) add(`t${i}`, i);
    await clock.advance(0);
    sink.isOpen = true;
    buffer.flush();
    expect(frames.flat()).toHaveLength(PUBLISH_LIMITS.awayTopics);
    expect(frames.flat()[0]).toBe('t5=5');
    expect(buffer.dropped).toBe(5);
  });

  it('keeps a bounded number of bytes, but always the newest record', async () => {
    const { buffer, frames, clock, sink } = setupAway();
    const text = 'x'.repeat(PUBLISH_LIMITS.waitingBytes);
    for (const topic of ['a', 'b']) {
      buffer.add(
        { topic, bytes: encodeRecord({ topic, format: 'string', value: text }), isEvent: false },
        false,
      );
    }
    await clock.advance(0);
    sink.isOpen = true;
    buffer.flush();
    expect(frames).toHaveLength(1);
    expect(buffer.dropped).toBe(1);
  });

  it('counts what clear() throws away', () => {
    const { add, buffer, clock } = setupAway();
    add('a', 1);
    add('b', 1);
    buffer.clear();
    expect(buffer.dropped).toBe(2);
    expect(clock.timerCount).toBe(0);
  });
});
