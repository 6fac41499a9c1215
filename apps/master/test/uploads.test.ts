import { RecordingState } from '@ubii/proto';
import { manyMarkers } from '@ubii/recording/testing';
import { describe, expect, it } from 'vitest';
import { MemoryRecording } from '../src/testing/memory-folder.ts';
import { TestMaster } from '../src/testing/index.ts';
import { TRUSTED_CALLER } from '../src/core/ports/caller-facts.ts';
import { SERVICES } from './recording-world.ts';

const FILE = manyMarkers(2);

/** An upload that arrives when its test says so. */
function begin(
  master: TestMaster,
  id: string,
  { bytes = 0, isAwaited = true, place = 'here' } = {},
) {
  let arrive: () => void = () => undefined;
  const arrived = new Promise<void>((resolve) => (arrive = resolve));
  const upload = {
    id,
    declaredBytes: bytes,
    isAwaited: () => isAwaited,
    async receive(take: (bytes: number) => Promise<void>): Promise<void> {
      await arrived;
      await take(FILE.length);
      master.recordings.uploads.set(id, new MemoryRecording(FILE));
    },
  };
  const caller = { ...TRUSTED_CALLER, place };
  return { arrive, taken: master.master.uploadRecording(upload, id, caller) };
}

async function listed(master: TestMaster): Promise<string[]> {
  const { recordingList } = await master.call({ topic: `${SERVICES}recording_list` });
  return recordingList!.elements.map(({ name }) => name);
}

describe('uploads of recordings', () => {
  it('[RC-47] of one sender are counted together, and those of others apart', async () => {
    const master = new TestMaster({ limits: { uploadsPerClient: 2, uploadBytesPerClient: 5_000 } });
    const first = begin(master, 'first', { bytes: 3_000 });
    await expect(begin(master, 'large', { bytes: 3_000 }).taken).rejects.toMatchObject({
      details: { limit: 'uploadBytesPerClient' },
    });
    const second = begin(master, 'second');
    await expect(begin(master, 'third').taken).rejects.toMatchObject({
      details: { limit: 'uploadsPerClient' },
    });
    const other = begin(master, 'other', { place: '10.0.0.7' });
    for (const { arrive, taken } of [first, second, other]) {
      arrive();
      await taken;
    }
    const next = begin(master, 'next');
    next.arrive();
    expect((await next.taken).state).toBe(RecordingState.RECORDING_STATE_COMPLETE);
  });

  it('[RC-42] that were closed before they were checked leave nothing', async () => {
    const master = new TestMaster();
    const { arrive, taken } = begin(master, 'cut', { isAwaited: false });
    arrive();
    await expect(taken).rejects.toMatchObject({ code: 'deadline_exceeded' });
    expect(await listed(master)).toEqual([]);
    expect(master.recordings.files.size).toBe(0);
  });
});
