import { encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { PlayerState } from '../reading/recording-messages.ts';
import { aRecording, fakeRecording } from './testing/fake-recording.ts';

function setUp() {
  const frames: (() => void)[] = [];
  const clock = { nowMs: 0 };
  const { player, ...rest } = fakeRecording(
    aRecording(),
    (fn) => frames.push(fn),
    () => clock.nowMs,
  );
  return {
    ...rest,
    opened: player,
    clock,
    frame: () => frames.splice(0).forEach((fn) => fn()),
  };
}

const pausedAt = (timeMs: number): PlayerState => ({
  status: 'paused',
  timeMs,
  rate: 1,
  loop: undefined,
  isBuffering: false,
});
const value = (topic: string, number: number) => ({
  topic,
  timeMs: 10,
  record: encodeRecord({ topic, format: 'double', value: number }),
});

describe('a recording that is opened', () => {
  it('has its playhead where it is dragged to, whatever comes from before', () => {
    const { opened, page, sent } = setUp();
    opened.seek(400);
    expect(opened.timeMs.value).toBe(400);
    page.showPlayer(pausedAt(0));
    expect(opened.timeMs.value).toBe(400);
    page.showPlayer(pausedAt(400));
    page.showPlayer(pausedAt(420));
    expect(opened.timeMs.value).toBe(420);
    expect(sent.at(-1)).toEqual(['seek', 400]);
  });

  it('cannot be dragged beyond its ends', () => {
    const { opened } = setUp();
    opened.seek(-5);
    expect(opened.timeMs.value).toBe(0);
    opened.seek(5000);
    expect(opened.timeMs.value).toBe(1000);
  });

  it('shows the values of the playhead in the next frame, and often enough while it plays', () => {
    const { opened, page, frame, clock } = setUp();
    page.showValues([value('/a', 1), value('/b', 2)], true);
    expect(opened.values.get('/a')).toBeUndefined();
    frame();
    expect(opened.values.get('/a')?.text).toBe('1.00');
    page.showValues([value('/a', 3)], false);
    frame();
    expect(opened.values.get('/a')?.text).toBe('1.00');
    clock.nowMs = 50;
    page.showValues([], false);
    frame();
    expect(opened.values.get('/a')?.text).toBe('3.00');
    page.showValues([value('/a', 4)], false);
    page.showPlayer(pausedAt(20));
    frame();
    expect(opened.values.get('/a')?.text).toBe('4.00');
    expect(opened.values.get('/b')?.text).toBe('2.00');
  });

  it('forgets topics that have no value where it was dragged to', () => {
    const { opened, page, frame } = setUp();
    page.showValues([value('/a', 1)], true);
    frame();
    page.showValues([value('/b', 2)], true);
    frame();
    expect(opened.values.get('/a')).toBeUndefined();
    expect(opened.values.get('/b')?.text).toBe('2.00');
  });

  it('says why it cannot be read', () => {
    const { opened, page } = setUp();
    page.showFailure('Not an MCAP file.');
    expect(opened.failure.value).toBe('Not an MCAP file.');
    page.showOpened(aRecording());
    expect(opened.failure.value).toBeUndefined();
  });
});
