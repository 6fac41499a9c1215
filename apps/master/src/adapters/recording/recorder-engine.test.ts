import { DEFAULT_TEXT_LIMITS, RecordingState } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import {
  addAll,
  recorderSuite,
  recordsToKeep,
  runningJob,
} from '../../testing/acceptance/index.ts';
import { MemoryFolder } from '../../testing/index.ts';
import { MemoryRecording } from '../../testing/memory-folder.ts';
import { readRecording } from '../../testing/read-recording.ts';
import {
  LocalChecker,
  recordHere,
  type FileChecker,
  type Recorder,
} from '@ubii/recording/recorder';
import { manyMarkers, metadataIndexOf3Gib, recordChunkIndexOf3Gib } from '@ubii/recording/testing';

const LIMITS = {
  ...DEFAULT_TEXT_LIMITS,
  recordingsBytes: 1e9,
  markersPerRecording: 100,
  recorderQueueBytes: 1e6,
};

function openEngine({
  folder = new MemoryFolder(),
  limits = LIMITS,
  checker,
}: { folder?: MemoryFolder; limits?: typeof LIMITS; checker?: FileChecker } = {}) {
  const clock = new FakeClock();
  const parts = { folder, clock, limits, ...(checker && { checker }) };
  return { folder, clock, recorder: recordHere(parts) };
}

recorderSuite('RecorderEngine in memory', () => {
  const { folder, recorder } = openEngine();
  return {
    recorder,
    file: (id) => folder.open(id),
    reopen: () => openEngine({ folder }).recorder,
  };
});

/** Lets time pass, and what it caused happen. */
async function pass(clock: FakeClock, ms: number): Promise<void> {
  for (let passed = 0; passed < ms; passed += 500) {
    clock.advanceSync(500);
    for (let i = 0; i < 100; i++) await Promise.resolve();
  }
}

describe('RecorderEngine', () => {
  it('[RC-16] stops recordings that reached their duration, their size or too little free space', async () => {
    const { recorder, clock, folder } = openEngine();
    const budget = { maxDurationMs: 1e9, maxBytes: 1e9, minFreeBytes: 0 };
    await recorder.start(runningJob('long', { budget: { ...budget, maxDurationMs: 1_000 } }));
    await recorder.start(
      runningJob('large', { target: 4, budget: { ...budget, maxBytes: 2_000 } }),
    );
    await recorder.start(runningJob('full', { target: 8, budget: { ...budget, minFreeBytes: 5 } }));
    addAll(recorder, recordsToKeep('/x', 500, 4));
    folder.free = 4;
    await pass(clock, 2_000);
    const { recordings } = await recorder.list();
    const problems = Object.fromEntries(recordings.map(({ id, problem }) => [id, problem]));
    expect(problems).toEqual({
      long: 'The recording stopped: it reached its longest duration.',
      large: 'The recording stopped: its file reached its largest size.',
      full: 'The recording stopped: little space is free on the disk.',
    });
    for (const { state } of recordings) expect(state).toBe(RecordingState.RECORDING_STATE_COMPLETE);
  });

  it('[RC-5] has a recording in its list, and to read, while its file is being closed', async () => {
    const { recorder } = openEngine();
    await recorder.start(runningJob('a'));
    addAll(recorder, recordsToKeep('/x', 10));
    const stopped = recorder.stop('a');
    for (let turn = 0; turn < 100; turn++) {
      await Promise.resolve();
      const [{ recordings }, { recording }] = await Promise.all([
        recorder.list(),
        recorder.get('a'),
      ]);
      expect(recordings.map(({ id }) => id)).toEqual(['a']);
      expect(recording.id).toBe('a');
    }
    expect(await stopped).toMatchObject({ id: 'a', recordCount: 10 });
  });

  it('[RC-17] keeps what was written before the disk was full, and records others', async () => {
    const { recorder, folder, clock } = openEngine();
    folder.maxBytes = 40_000;
    await recorder.start(runningJob('full'));
    folder.maxBytes = Infinity;
    await recorder.start(runningJob('other', { target: 4 }));
    addAll(recorder, recordsToKeep('/first', 10, 2 | 4));
    await pass(clock, 500);
    for (let i = 0; i < 20; i++) {
      addAll(recorder, recordsToKeep(`/lab/${i}/${'x'.repeat(i)}`, 100, 2 | 4));
      await pass(clock, 500);
    }
    const { recordings } = await recorder.list();
    const full = recordings.find(({ id }) => id === 'full')!;
    expect(full.state).toBe(RecordingState.RECORDING_STATE_FAILED);
    expect(full.problem).toContain('ENOSPC');
    expect(await recorder.stop('other')).toMatchObject({ recordCount: 2_010 });
    const { recorder: next } = openEngine({ folder });
    const listed = (await next.list()).recordings.find(({ id }) => id === 'full')!;
    expect(listed.recordCount).toBeGreaterThanOrEqual(10);
    const { values } = await readRecording(await folder.open('full'));
    expect(values.length).toBe(listed.recordCount);
  });

  it('[RC-7] repairs what an earlier run left open, and says what is missing', async () => {
    const { recorder, folder, clock } = openEngine();
    await recorder.start(runningJob('cut'));
    addAll(recorder, recordsToKeep('/x', 10));
    await pass(clock, 500);
    addAll(recorder, recordsToKeep('/lost', 10));
    const { recorder: next } = openEngine({ folder });
    const [cut] = (await next.list()).recordings;
    expect(cut).toMatchObject({ id: 'cut', recordCount: 10, topicCount: 1 });
    expect(cut!.state).toBe(RecordingState.RECORDING_STATE_REPAIRED);
    expect(cut!.problem).toContain('may be missing');
    const { recorder: third } = openEngine({ folder });
    expect((await third.list()).recordings).toMatchObject([{ id: 'cut', state: cut!.state }]);
  });

  it('[RC-45] lists files that it cannot read with the reason, does not read them again, and deletes them', async () => {
    const { recorder, folder } = openEngine();
    folder.files.set('liar', new MemoryRecording(metadataIndexOf3Gib()));
    folder.files.set('markers', new MemoryRecording(manyMarkers()));
    folder.files.set('text', new MemoryRecording(new TextEncoder().encode('Not a recording.')));
    await recorder.start(runningJob('own'));
    const rejected = async (from: Recorder) =>
      (await from.list()).recordings
        .filter(({ state }) => state === RecordingState.RECORDING_STATE_REJECTED)
        .map(({ id, problem }) => ({ id, problem }));
    const before = await rejected(recorder);
    expect(before.map(({ id }) => id).sort()).toEqual(['liar', 'markers', 'text']);
    for (const { problem } of before) expect(problem).toMatch(/^The file cannot be read. [A-Z]/);
    expect([...folder.files.keys()]).toEqual(['own']);
    expect((await recorder.stop('own')).state).toBe(RecordingState.RECORDING_STATE_COMPLETE);

    const { recorder: next } = openEngine({ folder });
    expect(await rejected(next)).toEqual(before);
    expect((await next.get('liar')).recording.problem).toContain('cannot be read');
    const refusal = { code: 'failed_precondition' };
    await expect(next.change('liar', { name: 'x', notes: '' })).rejects.toMatchObject(refusal);
    for (const { id } of before) await next.delete(id);
    expect(await rejected(next)).toEqual([]);
    expect(folder.rejectedFiles.size).toBe(0);
  });

  it('[RC-45] an upload that ended its check is kept, rejected, for the one who sent it', async () => {
    const { recorder, folder } = openEngine({
      checker: {
        check: () => Promise.resolve({ kind: 'unchecked', reason: 'It ended.' }),
        close: () => Promise.resolve(),
      },
    });
    folder.uploads.set('bad', new MemoryRecording(manyMarkers(2)));
    const refused = { code: 'invalid_argument', message: 'The file cannot be read. It ended.' };
    await expect(recorder.adopt(runningJob('bad'))).rejects.toMatchObject(refused);
    expect(await recorder.get('bad')).toMatchObject({
      makerId: 'grant',
      recording: { name: 'Recording bad', problem: 'The file cannot be read. It ended.' },
    });
    folder.uploads.set('node', new MemoryRecording(manyMarkers(2)));
    const ofNode = { ...runningJob('node'), isOfNode: true };
    await expect(recorder.adopt(ofNode)).rejects.toMatchObject(refused);
    await expect(recorder.get('node')).rejects.toMatchObject({ code: 'not_found' });
    expect(folder.uploads.size).toBe(0);
  });

  it('[RC-44] an upload is an upload until it was checked', async () => {
    const { recorder, folder } = openEngine();
    folder.uploads.set('liar', new MemoryRecording(recordChunkIndexOf3Gib()));
    await expect(recorder.adopt(runningJob('liar'))).rejects.toMatchObject({
      code: 'invalid_argument',
    });
    expect([folder.files.size, folder.uploads.size, folder.rejectedFiles.size]).toEqual([0, 0, 0]);
    const seen: boolean[] = [];
    const local = new LocalChecker(folder, LIMITS);
    const { recorder: other } = openEngine({
      folder,
      checker: {
        check(job) {
          seen.push(folder.files.has('good'));
          return local.check(job);
        },
        close: () => Promise.resolve(),
      },
    });
    folder.uploads.set('good', new MemoryRecording(manyMarkers(2)));
    await other.adopt(runningJob('good'));
    expect([seen, folder.files.has('good')]).toEqual([[false], true]);
  });

  it('[RC-18] deletes the oldest keepings of the flight recorder, and nothing else', async () => {
    const { recorder: first, folder } = openEngine();
    await first.start(runningJob('wanted'));
    addAll(first, recordsToKeep('/x', 20));
    const { sizeBytes: bytesOfOne } = await first.stop('wanted');
    const recordingsBytes = 4 * bytesOfOne;
    const { recorder, clock } = openEngine({ folder, limits: { ...LIMITS, recordingsBytes } });
    const flight = { isOn: true, minutes: 5, maxBytes: 1e6, withImages: true, present: [] };
    await recorder.setFlight(flight);
    addAll(recorder, recordsToKeep('/x', 20, 1));
    for (const id of ['k1', 'k2', 'k3', 'k4', 'k5', 'k6']) {
      await recorder.keep(runningJob(id));
      await pass(clock, 500);
    }
    const { recordings, sizeBytes } = await recorder.list();
    const ids = recordings.map(({ id }) => id);
    expect(ids).toContain('wanted');
    expect(ids).toContain('k6');
    expect(ids).not.toContain('k1');
    expect(sizeBytes).toBeLessThanOrEqual(recordingsBytes);
    expect(folder.files.size).toBe(ids.length);
  });

  it('[RC-23] refuses more markers than a recording may have', async () => {
    const { recorder } = openEngine({ limits: { ...LIMITS, markersPerRecording: 2 } });
    await recorder.start(runningJob('a'));
    const job = (id: string) => ({
      marker: {
        recordingId: 'a',
        id,
        timeMs: 1,
        text: '',
        author: '',
        clientId: '',
        isRemoved: false,
      },
      mayChangeAll: true,
    });
    await recorder.mark(job('1'));
    await recorder.mark(job('2'));
    await expect(recorder.mark(job('3'))).rejects.toMatchObject({ code: 'resource_exhausted' });
  });

  it('[RC-30] counts records per second in slots', async () => {
    const { recorder, clock } = openEngine();
    const flight = { isOn: true, minutes: 1, maxBytes: 1e6, withImages: true, present: [] };
    await recorder.setFlight(flight);
    const timeMs = clock.nowMs();
    addAll(
      recorder,
      recordsToKeep('/x', 30, 1).map((record) => ({ ...record, timeMs })),
    );
    const { recordsPerSecond } = await recorder.flight();
    expect(recordsPerSecond).toHaveLength(60);
    expect(recordsPerSecond.at(-1)).toBe(30);
    expect(recordsPerSecond.at(-2)).toBe(0);
  });
});
