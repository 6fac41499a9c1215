import { encodeRecord, type Recording } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import type { NamedChannel } from '../arena/channels.ts';
import {
  FLIGHT_TARGET,
  SharedReader,
  type RecordSpans,
  type SharedRecords,
} from '../arena/shared-records.ts';
import type { RecordingEvent } from '../records/recording-event.ts';
import type { FileRecorder, FileState } from './file-recorder.ts';
import { SharedRecorder } from './shared-recorder.ts';
import type { RecorderState, RunningJob } from './recorder.ts';

const FILE_TARGET = 2;
const FLIGHT = { isOn: true, minutes: 1, maxBytes: 100_000, withImages: true, present: [] };

/** Files that note what they are told, and read when they are asked. */
class FakeFiles {
  generation = 0;
  readonly events: RecordingEvent[] = [];
  readonly memories: SharedRecords[] = [];
  readonly erased: SharedRecords[] = [];
  readonly batches: string[][] = [];
  readonly #channels = new Map<number, NamedChannel>();
  #listener: (state: FileState) => void = () => undefined;

  open(memory: SharedRecords): void {
    this.memories.push(memory);
    this.#channels.clear();
  }
  erase(memory: SharedRecords): void {
    this.erased.push(memory);
  }
  addEvent(event: RecordingEvent): void {
    this.events.push(event);
  }
  read(spans: RecordSpans, channels: readonly NamedChannel[]): Promise<void> {
    for (const channel of channels) this.#channels.set(channel.number, channel);
    const entries = [...new SharedReader(this.memories.at(-1)!).read(spans)];
    const ofFiles = entries.filter(({ targets }) => (targets & FILE_TARGET) !== 0);
    this.batches.push(ofFiles.map(({ channel }) => this.#channels.get(channel)!.topic));
    return Promise.resolve();
  }
  start(): Promise<Recording> {
    this.tell(FILE_TARGET);
    return Promise.resolve({} as Recording);
  }
  keep(): Promise<Recording> {
    return Promise.resolve({} as Recording);
  }
  close(): Promise<void> {
    return Promise.resolve();
  }
  onState(listener: (state: FileState) => void): void {
    this.#listener = listener;
  }
  tell(targets: number): void {
    this.#listener({ running: [], targets, listRevision: 1 });
  }
}

function setUp(recorderQueueBytes = 100_000) {
  const clock = new FakeClock();
  const files = new FakeFiles();
  const limits = { recorderQueueBytes, markersPerRecording: 10 };
  const recorder = new SharedRecorder({
    clock,
    limits,
    files: files as unknown as FileRecorder,
  });
  const states: RecorderState[] = [];
  recorder.onState((state) => states.push(state));
  const source = (topic: string) => ({ topic, clientId: 'ada', channel: undefined });
  return {
    clock,
    files,
    recorder,
    states,
    add(topic: string, targets: number, timeMs = clock.nowMs()): void {
      const record = encodeRecord({ topic, format: 'double', value: 1 });
      recorder.add(source(topic), record, timeMs, targets);
    },
    start: () => recorder.start({} as RunningJob),
  };
}

describe('a recorder in shared memory', () => {
  it('[RC-50] tells files every 50 ms of records for them, and not of others', async () => {
    const { add, start, files, clock } = setUp();
    await start();
    add('/a', FILE_TARGET);
    add('/flight', FLIGHT_TARGET);
    add('/b', FILE_TARGET);
    await clock.advance(49);
    expect(files.batches).toEqual([]);
    await clock.advance(1);
    expect(files.batches).toEqual([['/a', '/b']]);
    add('/flight', FLIGHT_TARGET);
    await clock.advance(100);
    expect(files.batches).toHaveLength(1);
  });

  it('[RC-50] tells files nothing of what only the flight recorder keeps', async () => {
    const { add, recorder, files, clock, states } = setUp();
    await recorder.setFlight(FLIGHT);
    for (let i = 0; i < 1_000; i++) add('/x', FLIGHT_TARGET);
    await clock.advance(1_000);
    expect(files).toMatchObject({ memories: [], batches: [], events: [] });
    expect(states.at(-1)!.flight).toMatchObject({ recordCount: 1_000, topicCount: 1 });
  });

  it('[RC-19] counts records that were overwritten before files read them, as a gap before the next', async () => {
    const { add, start, files, recorder } = setUp(300);
    await start();
    for (let i = 0; i < 10; i++) add('/x', FILE_TARGET);
    recorder.flush();
    const kept = files.batches.flat().length;
    expect(kept).toBeGreaterThan(0);
    expect(files.events).toMatchObject([{ kind: 'gap', value: { records: 10 - kept } }]);
  });

  it('[RC-31] has what it held overwritten when it is turned off', async () => {
    const { add, recorder, files } = setUp();
    await recorder.setFlight(FLIGHT);
    add('/x', FLIGHT_TARGET);
    await recorder.setFlight({ ...FLIGHT, isOn: false });
    expect(files.erased).toHaveLength(1);
    await recorder.setFlight(FLIGHT);
    expect(await recorder.flight()).toMatchObject({ recordCount: 0, topicCount: 0 });
  });

  it('[RC-31] keeps the newest records when it gets more or less memory', async () => {
    const { add, recorder, clock } = setUp(1_000);
    await recorder.setFlight(FLIGHT);
    for (let i = 0; i < 500; i++) add(`/${i % 2}`, FLIGHT_TARGET, clock.nowMs() + i);
    const before = await recorder.flight();
    const larger = await recorder.setFlight({ ...FLIGHT, maxBytes: 200_000 });
    expect(larger).toMatchObject({ recordCount: before.recordCount, heldMs: before.heldMs });
    const smaller = await recorder.setFlight({ ...FLIGHT, maxBytes: 10_000 });
    expect(smaller.recordCount).toBeGreaterThan(50);
    expect(smaller.heldBytes).toBeLessThanOrEqual(10_000);
  });

  it('gives memory and names again to files that start again', async () => {
    const { add, start, files, recorder } = setUp();
    await start();
    add('/x', FILE_TARGET);
    recorder.flush();
    files.generation++;
    add('/x', FILE_TARGET);
    recorder.flush();
    files.generation++;
    void recorder.keep({} as RunningJob);
    add('/x', FILE_TARGET);
    recorder.flush();
    expect(files.memories).toHaveLength(3);
    expect(files.batches).toEqual([['/x'], ['/x'], ['/x']]);
  });

  it('records nothing that came before a recording started', async () => {
    const { add, start, files, recorder } = setUp();
    await recorder.setFlight(FLIGHT);
    add('/before', FLIGHT_TARGET | FILE_TARGET);
    files.tell(0);
    await start();
    add('/after', FILE_TARGET);
    recorder.flush();
    expect(files.batches.at(-1)).toEqual(['/after']);
  });

  it('starts over when the clock is set back by more than it holds', async () => {
    const { add, recorder, clock } = setUp();
    await recorder.setFlight(FLIGHT);
    add('/x', FLIGHT_TARGET);
    add('/x', FLIGHT_TARGET, clock.nowMs() - 3_600_000);
    expect(await recorder.flight()).toMatchObject({ recordCount: 1, heldMs: 0 });
  });
});
