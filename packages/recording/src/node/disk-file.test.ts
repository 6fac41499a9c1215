import { readFileSync, truncateSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { expect, it } from 'vitest';
import { RecordingError } from '../records/recording-error.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import { repairRecording } from '../repair/repair-recording.ts';
import { SAMPLE_HEADER, sampleRecord } from '../testing/sample-records.ts';
import { RecordingWriter } from '../writing/recording-writer.ts';
import { DiskFile } from './disk-file.ts';

it('writes, reads, cuts and repairs a file on disk', async () => {
  const path = join(temporaryFolder(), 'a.mcap');
  const file = await DiskFile.create(path);
  const writer = await RecordingWriter.create(file, SAMPLE_HEADER);
  for (let i = 0; i < 100; i++) await writer.addRecord(sampleRecord('/a', i * 50));
  await writer.flush();
  await file.sync();
  const size = readFileSync(path).length;
  expect(file.position()).toBe(BigInt(size));
  await writer.end();
  await file.close();
  await expect(DiskFile.create(path)).rejects.toThrow('EEXIST');

  truncateSync(path, size + 3);
  const edited = await DiskFile.edit(path);
  expect(await repairRecording(edited)).toMatchObject({ records: 100 });
  await edited.close();

  const opened = await DiskFile.open(path);
  const { summary } = await RecordingReader.open(opened);
  expect(summary).toMatchObject({ records: 100, isDamaged: false, ...SAMPLE_HEADER });
  await expect(opened.read(await opened.size(), 1n)).rejects.toThrow(RecordingError);
  // Node aborts the process when it is asked for so much. [RC-43]
  await expect(opened.read(0n, 3n * 1024n ** 3n)).rejects.toThrow(RecordingError);
  await opened.close();
});
