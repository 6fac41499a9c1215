import { expect, it } from 'vitest';
import { RecordingError } from '../records/recording-error.ts';
import { RecordingReader } from '../reading/recording-reader.ts';
import {
  attachmentIndexOf3Gib,
  lz4Bomb,
  manyMarkers,
  manyMarkersWithoutEnd,
  markerChunkIndexOf3Gib,
  MemoryFile,
  metadataIndexOf3Gib,
  recordChunkIndexOf3Gib,
} from '../testing/index.ts';

const open = (bytes: Uint8Array) => RecordingReader.open(new MemoryFile(bytes));

it.each([
  ['a header of 3 GiB', metadataIndexOf3Gib, 'metadata at byte 8'],
  ['a chunk of events of 3 GiB', markerChunkIndexOf3Gib, 'chunk at byte'],
  ['a chunk of records of 3 GiB', recordChunkIndexOf3Gib, 'chunk at byte'],
  ['a snapshot of 3 GiB', attachmentIndexOf3Gib, 'attachment at byte 8'],
  ['a chunk that becomes 1.1 GB', lz4Bomb, 'chunk at byte'],
  ['a chunk of five million events', manyMarkers, 'chunk'],
  ['too many events to open it', () => manyMarkers(100_001), 'too many events'],
  ['such a chunk, and no end', manyMarkersWithoutEnd, 'chunk'],
])('[RC-43] a file with %s is refused before it is read', async (_, build, what) => {
  const refused = await open(build()).catch((error: unknown) => error);
  expect(refused).toBeInstanceOf(RecordingError);
  expect((refused as Error).message).toContain(what);
});
