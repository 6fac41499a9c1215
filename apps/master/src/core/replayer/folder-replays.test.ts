import { RecordingError } from '@ubii/recording';
import { recorded, recordedDevice, SAMPLE_START_NS, sampleRecord } from '@ubii/recording/testing';
import { FakeClock } from '@ubii/timing/testing';
import { expect, it } from 'vitest';
import { MemoryFolder, MemoryRecording } from '../../testing/memory-folder.ts';
import { FolderReplays } from './folder-replays.ts';

it('[RP-1] refuses what needs a part of the file that is damaged', async () => {
  const value = recordedDevice('d', 'ada', []);
  const { bytes } = await recorded(
    [sampleRecord('/a', 0)],
    [{ kind: 'device', timeNs: SAMPLE_START_NS, value }],
  );
  const file = new MemoryRecording(bytes);
  const folder = new MemoryFolder();
  folder.files.set('lesson', file);
  const replay = await new FolderReplays({ folder, clock: new FakeClock() }).open('lesson');
  file.read = () => Promise.reject(new RecordingError('A chunk is cut off.'));
  const refusal = {
    code: 'failed_precondition',
    message: 'The recording "lesson" cannot be read: A chunk is cut off.',
  };
  const { startNs: fromNs, endNs: untilNs } = replay.facts;
  await expect(replay.devices({ fromNs, untilNs })).rejects.toMatchObject(refusal);
  await expect(replay.session('s', 0n)).resolves.toBeUndefined();
});
