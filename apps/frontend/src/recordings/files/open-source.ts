import type { RecordingSource } from '@ubii/recording';
import { BlobSource, RangeSource } from '@ubii/recording/browser';
import { fetchFile, type ReadableFile } from './readable-file.ts';

/** The bytes of a recording, read as they are needed. */
export function openSource(file: ReadableFile): RecordingSource {
  if (file instanceof Blob) return new BlobSource(file);
  return new RangeSource(file.url, (_url, init) => fetchFile(file, init));
}
