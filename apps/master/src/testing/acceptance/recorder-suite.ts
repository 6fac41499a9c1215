import {
  decodeRecord,
  encodeRecord,
  RecordingKind,
  RecordingState,
  ServiceError,
  unpackFlightRecords,
  type RecordingMarker,
} from '@ubii/proto';
import type { RecordingSource } from '@ubii/recording';
import { describe, expect, it } from 'vitest';
import type { Recorder, RecorderState, RunningJob } from '../../core/ports/index.ts';
import type { ChannelSource } from '@ubii/recording/recorder';
import { readRecording } from '../read-recording.ts';

/** A recorder with its files. */
export interface RecorderParts {
  readonly recorder: Recorder;
  /** The file of a recording. */
  file(id: string): Promise<RecordingSource>;
  /** A recorder of the next run, with the same files. */
  reopen(): Recorder;
}

const FIRST_PAGE = { topicsFrom: 0, markersFrom: 0 };
const TARGET = 2;
const OTHER_TARGET = 4;
const START_MS = 1_750_000_000_000;
const SELECTION = { topics: [], patterns: [], clients: [], devices: [], sessions: [] };

/** A recording to start. */
export function runningJob(id: string, more: Partial<RunningJob> = {}): RunningJob {
  return {
    id,
    name: `Recording ${id}`,
    notes: '',
    author: 'Ada',
    makerId: 'grant',
    masterName: 'Lab',
    version: '1.2.3',
    personalData: '',
    target: TARGET,
    present: [],
    selection: { ...SELECTION, excludedPatterns: [], withoutImages: false },
    budget: { maxDurationMs: 1e9, maxBytes: 1e9, minFreeBytes: 0 },
    ...more,
  };
}

/** A record for a recorder. */
export interface SampleRecord {
  readonly source: ChannelSource;
  readonly record: Uint8Array;
  readonly timeMs: number;
  readonly targets: number;
}

/** Records of one topic with the values 0, 1, 2 … */
export function recordsToKeep(topic: string, count: number, targets = TARGET): SampleRecord[] {
  const source = { topic, clientId: 'ada-id', channel: undefined };
  return Array.from({ length: count }, (_, index) => ({
    source,
    record: encodeRecord({ topic, format: 'double', value: index }),
    timeMs: START_MS + index,
    targets,
  }));
}

/** Gives records to a recorder. */
export function addAll(recorder: Recorder, records: readonly SampleRecord[]): void {
  for (const { source, record, timeMs, targets } of records) {
    recorder.add(source, record, timeMs, targets);
  }
}

function marker(id: string, more: Partial<RecordingMarker> = {}): RecordingMarker {
  return {
    recordingId: '',
    id,
    timeMs: START_MS + 1,
    text: 'here',
    author: 'Ada',
    clientId: 'ada-id',
    isRemoved: false,
    ...more,
  };
}

/** What every recorder does. */
export function recorderSuite(name: string, open: () => RecorderParts): void {
  describe(`${name}, a Recorder`, () => {
    it('[RC-1] writes records bit for bit, with their topics and publishers', async () => {
      const { recorder, file } = open();
      const started = await recorder.start(runningJob('a'));
      expect(started).toMatchObject({ id: 'a', name: 'Recording a', author: 'Ada' });
      expect(started.state).toBe(RecordingState.RECORDING_STATE_RECORDING);
      addAll(recorder, [...recordsToKeep('/lab/x', 3), ...recordsToKeep('/lab/y', 1)]);
      const stopped = await recorder.stop('a');
      expect(stopped).toMatchObject({ recordCount: 4, topicCount: 2, lostCount: 0, problem: '' });
      expect(stopped.state).toBe(RecordingState.RECORDING_STATE_COMPLETE);
      const { summary, values } = await readRecording(await file('a'));
      expect(summary).toMatchObject({ name: 'Recording a', kind: 'recording', masterName: 'Lab' });
      expect(summary.topics[0]).toMatchObject({ topic: '/lab/x', clientId: 'ada-id' });
      const sorted = [...values].sort(([a], [b]) => a.localeCompare(b));
      expect(sorted).toEqual([
        ['/lab/x', 0],
        ['/lab/x', 1],
        ['/lab/x', 2],
        ['/lab/y', 0],
      ]);
      await recorder.close();
    });

    it('writes only what a recording is the target of', async () => {
      const { recorder, file } = open();
      await recorder.start(runningJob('a'));
      await recorder.start(runningJob('b', { target: OTHER_TARGET }));
      const both = recordsToKeep('/both', 1, TARGET | OTHER_TARGET);
      addAll(recorder, [...both, ...recordsToKeep('/b', 1, OTHER_TARGET)]);
      await recorder.stop('a');
      addAll(recorder, recordsToKeep('/late', 1, TARGET | OTHER_TARGET));
      await recorder.close();
      expect((await readRecording(await file('a'))).values).toEqual([['/both', 0]]);
      const { values } = await readRecording(await file('b'));
      expect(values.map(([topic]) => topic)).toEqual(['/both', '/b', '/late']);
    });

    it('[RC-2] [RC-3] lists recordings, those of earlier runs as well', async () => {
      const { recorder, reopen } = open();
      await recorder.start(runningJob('a'));
      addAll(recorder, recordsToKeep('/x', 2));
      await recorder.close();
      const next = reopen();
      await next.start(runningJob('b'));
      const { recordings, sizeBytes } = await next.list();
      expect(recordings.map(({ id }) => id)).toEqual(['b', 'a']);
      expect(sizeBytes).toBeGreaterThan(0);
      const { recording, makerId } = await next.get('a', FIRST_PAGE);
      expect(makerId).toBe('grant');
      expect(recording.topics).toMatchObject([
        { topic: '/x', clientId: 'ada-id', dataFormat: 'double', recordCount: 2 },
      ]);
      await next.close();
    });

    it('[RC-66] tells whose a recording is, those of earlier runs as well', async () => {
      const { recorder, reopen } = open();
      await recorder.start(runningJob('a'));
      await recorder.close();
      const next = reopen();
      await next.start({ ...runningJob('b'), makerId: 'grant/client' });
      expect(await next.makerOf('a')).toBe('grant');
      expect(await next.makerOf('b')).toBe('grant/client');
      expect([...(await next.list()).makers].sort()).toEqual([
        ['a', 'grant'],
        ['b', 'grant/client'],
      ]);
      await expect(next.makerOf('c')).rejects.toMatchObject({ code: 'not_found' });
      await next.close();
    });

    it('[RC-3] tells what is recorded of each topic while it runs', async () => {
      const { recorder } = open();
      await recorder.start(runningJob('a'));
      addAll(recorder, [...recordsToKeep('/lab/x', 3), ...recordsToKeep('/lab/y', 1)]);
      const counts = async (): Promise<(string | number)[][]> => {
        const { topics } = (await recorder.get('a', FIRST_PAGE)).recording;
        return topics.map(({ topic, clientId, recordCount }) => [topic, clientId, recordCount]);
      };
      await expect.poll(counts).toEqual([
        ['/lab/x', 'ada-id', 3],
        ['/lab/y', 'ada-id', 1],
      ]);
      await recorder.close();
    });

    it('[RC-6] changes name and notes of running and finished recordings', async () => {
      const { recorder, reopen } = open();
      await recorder.start(runningJob('a'));
      await recorder.change('a', { name: 'Lesson', notes: 'first' });
      expect(await recorder.stop('a')).toMatchObject({ name: 'Lesson', notes: 'first' });
      await recorder.change('a', { name: 'Lesson 1', notes: '' });
      await recorder.close();
      const next = reopen();
      expect((await next.get('a')).recording).toMatchObject({ name: 'Lesson 1', notes: '' });
      await next.close();
    });

    it('[RC-5] deletes recordings, running ones as well', async () => {
      const { recorder } = open();
      await recorder.start(runningJob('a'));
      await recorder.delete('a');
      expect((await recorder.list()).recordings).toEqual([]);
      await expect(recorder.get('a')).rejects.toMatchObject({ code: 'not_found' });
      await expect(recorder.delete('a')).rejects.toBeInstanceOf(ServiceError);
      await recorder.close();
    });

    it('[RC-20] [RC-22] adds, changes and removes markers while it records and later', async () => {
      const { recorder } = open();
      await recorder.start(runningJob('a'));
      addAll(recorder, recordsToKeep('/x', 1));
      await recorder.mark({ marker: marker('m'), mayChangeAll: false });
      await recorder.mark({ marker: marker('n', { text: 'gone' }), mayChangeAll: false });
      await recorder.mark({ marker: marker('n', { isRemoved: true }), mayChangeAll: false });
      await recorder.stop('a');
      const ofFile = marker('m', { recordingId: 'a', text: 'there', author: 'Bob' });
      await recorder.mark({ marker: ofFile, mayChangeAll: true });
      const { markers, markerCount } = (await recorder.get('a', FIRST_PAGE)).recording;
      expect(markers).toMatchObject([
        { id: 'm', text: 'there', author: 'Ada', timeMs: START_MS + 1 },
      ]);
      expect(markerCount).toBe(1);
      await recorder.close();
    });

    it('[RC-21] leaves markers of others, and of finished recordings, to those that may', async () => {
      const { recorder } = open();
      const denied = { code: 'permission_denied' };
      await recorder.start(runningJob('a'));
      await recorder.mark({ marker: marker('m'), mayChangeAll: false });
      const ofOther = marker('m', { clientId: 'bob-id' });
      await expect(recorder.mark({ marker: ofOther, mayChangeAll: false })).rejects.toMatchObject(
        denied,
      );
      await recorder.stop('a');
      const late = marker('late', { recordingId: 'a' });
      await expect(recorder.mark({ marker: late, mayChangeAll: false })).rejects.toMatchObject(
        denied,
      );
      const nowhere = { marker: marker('nowhere'), mayChangeAll: true };
      await expect(recorder.mark(nowhere)).rejects.toMatchObject({ code: 'failed_precondition' });
      await recorder.close();
    });

    it('[RC-30] [RC-32] keeps what the flight recorder holds, and goes on', async () => {
      const { recorder, file } = open();
      const settings = { isOn: true, minutes: 5, maxBytes: 1e6, withImages: true };
      await recorder.setFlight({ ...settings, present: [] });
      addAll(recorder, recordsToKeep('/x', 3, 1));
      await recorder.mark({ marker: marker('m'), mayChangeAll: false });
      const kept = await recorder.keep(runningJob('k', { name: 'Kept' }));
      expect(kept).toMatchObject({ name: 'Kept', recordCount: 3, markerCount: 1 });
      expect(kept.kind).toBe(RecordingKind.RECORDING_KIND_FLIGHT_RECORDER);
      expect((await readRecording(await file('k'))).values).toHaveLength(3);
      expect(await recorder.flight()).toMatchObject({ ...settings, recordCount: 3, topicCount: 1 });
      const off = await recorder.setFlight({ ...settings, isOn: false, present: [] });
      expect(off).toMatchObject({ isOn: false, heldBytes: 0, recordsPerSecond: [] });
      await recorder.close();
    });

    it('[RC-36] finds what the flight recorder holds of some topics, the newest of each', async () => {
      const { recorder } = open();
      const settings = { isOn: true, minutes: 5, maxBytes: 1e6, withImages: true };
      await recorder.setFlight({ ...settings, present: [] });
      for (const topic of ['/x', '/y', '/z']) addAll(recorder, recordsToKeep(topic, 3, 1));
      recorder.endTopic('/x');
      const find = async (topics: string[], sinceMs = 0, maxBytes = 1e6) => {
        const found = await recorder.find({ topics, sinceMs, maxBytes });
        return Array.from(unpackFlightRecords(found), ({ record, timeMs }) => {
          const { topic, value } = decodeRecord(record);
          return { topic, value, timeMs };
        });
      };
      const all = await find(['/y', '/x', '/nothing']);
      expect(all.map(({ topic }) => topic).sort()).toEqual(['/x', '/x', '/x', '/y', '/y', '/y']);
      expect(all.map(({ value }) => value)).toEqual([0, 0, 1, 1, 2, 2]);
      expect(all.map(({ timeMs }) => timeMs - START_MS)).toEqual([0, 0, 1, 1, 2, 2]);
      const newest = [{ topic: '/y', value: 2, timeMs: START_MS + 2 }];
      expect(await find(['/y'], START_MS + 2)).toEqual(newest);
      const { length } = recordsToKeep('/y', 1)[0]!.record;
      expect(await find(['/y', '/x'], 0, 2 * length)).toEqual([
        { ...newest[0], topic: '/x' },
        ...newest,
      ]);
      expect(await find(['/nothing'])).toEqual([]);
      await recorder.setFlight({ ...settings, isOn: false, present: [] });
      expect(await find(['/y'])).toEqual([]);
      await recorder.close();
    });

    it('[RC-33] forgets topics that ended before what the flight recorder holds', async () => {
      const { recorder, file } = open();
      const settings = { isOn: true, minutes: 5, maxBytes: 50_000, withImages: true };
      await recorder.setFlight({ ...settings, present: [] });
      for (const topic of ['/ended', '/stays']) addAll(recorder, recordsToKeep(topic, 1, 1));
      recorder.endTopic('/ended');
      addAll(recorder, recordsToKeep('/x', 3_000, 1));
      await recorder.keep(runningJob('k'));
      const { summary } = await readRecording(await file('k'));
      expect(summary.topics.map(({ topic }) => topic).sort()).toEqual(['/stays', '/x']);
      await recorder.close();
    });

    it('[RC-8] tells when a recording starts and ends', async () => {
      const { recorder } = open();
      const states: RecorderState[] = [];
      recorder.onState((state) => states.push(state));
      await recorder.start(runningJob('a'));
      expect(states.at(-1)).toMatchObject({ targets: TARGET, running: [{ id: 'a' }] });
      await recorder.stop('a');
      expect(states.at(-1)).toMatchObject({ targets: 0, running: [] });
      expect(states.at(-1)!.listRevision).toBeGreaterThan(states[0]!.listRevision);
      await recorder.close();
    });

    it('[RC-19] writes gaps, and counts what is missing', async () => {
      const { recorder, file } = open();
      await recorder.start(runningJob('a'));
      const value = { fromMs: START_MS, untilMs: START_MS + 5, records: 7, reason: 'too fast' };
      const timeNs = BigInt(START_MS) * 1_000_000n;
      recorder.addEvent({ kind: 'gap', timeNs, value }, TARGET);
      expect(await recorder.stop('a')).toMatchObject({ lostCount: 7 });
      expect((await readRecording(await file('a'))).summary.gaps).toMatchObject([value]);
      await recorder.close();
    });
  });
}
