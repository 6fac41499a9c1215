import { serveCalls } from '@ubii/worker-rpc/browser';
import { readSessionFile, type ReadFile } from './read-session-file.ts';

/** Parses a large file off the main thread. */
export interface SessionFileWorker {
  read(file: File): Promise<ReadFile>;
}

serveCalls<SessionFileWorker>({
  read: async (file) => readSessionFile({ name: file.name, text: await file.text() }),
});
