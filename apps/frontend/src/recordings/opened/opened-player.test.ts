import { encodeRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { RecordingCommand, RecordingReport } from '../reading/recording-messages.ts';
import { createOpenedPlayer } from './opened-player.ts';

function setUp() {
  const sent: RecordingCommand[] = [];
  let tell: (report: RecordingReport) => void = () => undefined;
  const frames: (() => void)[] = [];
  const clock = { nowMs: 0 };
  const port = {
    send: (command: RecordingCommand) => sent.push(command),
    onReport: (handle: typeof tell) => (tell = handle),
    close: () => undefined,
  };
  const opened = createOpenedPlayer(
    port,
    { url: '/recordings/a.mcap', authorization: undefined },
    (fn) => frames.push(fn),
    () => clock.nowMs,
  );
  tell({ kind: 'opened', recording: A_RECORDING });
  return {
    opened,
    sent,
    clock,
    tell: (report: RecordingReport) => tell(report),
    frame: () => frames.splice(0).forEach((fn) => fn()),
  };
}

const A_RECORDING = {
  ...{ name: 'Study', notes: '', masterName: 'Studio', startMs: 0, durationMs: 1000, records: 2 },
  ...{
    topics: [],
    clientNames: new Map(),
    markers: [],
    gaps: [],
    isDamaged: false,
    labels: [],
  },
};
const player = (timeMs: number): RecordingReport => ({
  kind: 'player',
  player: { status: 'paused', timeMs, rate: 1, loop: undefined, isBuffering: false },
});
const value = (topic: string, number: number) => ({
  topic,
  timeMs: 10,
  record: encodeRecord({ topic, format: 'double', value: number }),
});

describe('a recording that is opened', () => {
  it('has its playhead where it is dragged to, whatever comes from before', () => {
    const { opened, tell, sent } = setUp();
    opened.seek(400);
    expect(opened.timeMs.value).toBe(400);
    tell(player(0));
    expect(opened.timeMs.value).toBe(400);
    tell(player(400));
    tell(player(420));
    expect(opened.timeMs.value).toBe(420);
    expect(sent.at(-1)).toEqual({ kind: 'seek', timeMs: 400 });
  });

  it('cannot be dragged beyond its ends', () => {
    const { opened } = setUp();
    opened.seek(-5);
    expect(opened.timeMs.value).toBe(0);
    opened.seek(5000);
    expect(opened.timeMs.value).toBe(1000);
  });

  it('shows the values of the playhead in the next frame, and often enough while it plays', () => {
    const { opened, tell, frame, clock } = setUp();
    tell({ kind: 'values', isAll: true, values: [value('/a', 1), value('/b', 2)] });
    expect(opened.values.get('/a')).toBeUndefined();
    frame();
    expect(opened.values.get('/a')?.text).toBe('1.00');
    tell({ kind: 'values', isAll: false, values: [value('/a', 3)] });
    frame();
    expect(opened.values.get('/a')?.text).toBe('1.00');
    clock.nowMs = 50;
    tell({ kind: 'values', isAll: false, values: [] });
    frame();
    expect(opened.values.get('/a')?.text).toBe('3.00');
    tell({ kind: 'values', isAll: false, values: [value('/a', 4)] });
    tell(player(20));
    frame();
    expect(opened.values.get('/a')?.text).toBe('4.00');
    expect(opened.values.get('/b')?.text).toBe('2.00');
  });

  it('forgets topics that have no value where it was dragged to', () => {
    const { opened, tell, frame } = setUp();
    tell({ kind: 'values', isAll: true, values: [value('/a', 1)] });
    frame();
    tell({ kind: 'values', isAll: true, values: [value('/b', 2)] });
    frame();
    expect(opened.values.get('/a')).toBeUndefined();
    expect(opened.values.get('/b')?.text).toBe('2.00');
  });

  it('says why it cannot be read', () => {
    const { opened, tell } = setUp();
    tell({ kind: 'failed', message: 'Not an MCAP file.' });
    expect(opened.failure.value).toBe('Not an MCAP file.');
    tell({ kind: 'opened', recording: A_RECORDING });
    expect(opened.failure.value).toBeUndefined();
  });
});
