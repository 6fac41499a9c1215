import { callWorker } from '@ubii/worker-rpc/browser';
import { FILE_LIMITS } from './file-limits.ts';
import { readSessionFile, refuseSize, type ReadFile } from './read-session-file.ts';
import type { SessionFileWorker } from './session-file-worker.ts';

/** Reads a chosen or dropped file without blocking the page. Never rejects. */
export async function openSessionFile(file: File): Promise<ReadFile> {
  const refused = refuseSize(file.name, file.size);
  if (refused) return refused;
  try {
    if (file.size <= FILE_LIMITS.bytesInPage) {
      return readSessionFile({ name: file.name, text: await file.text() });
    }
    return await readInWorker(file);
  } catch (cause) {
    // A folder, or a file that was removed in the meantime.
    const reason = cause instanceof Error ? cause.message : String(cause);
    const message = `${file.name} cannot be read: ${reason}`;
    return { kind: 'broken', name: file.name, message, text: undefined };
  }
}

async function readInWorker(file: File): Promise<ReadFile> {
  const worker = callWorker<SessionFileWorker>(
    new Worker(new URL('./session-file-worker.ts', import.meta.url), { type: 'module' }),
    {},
    'it is too large for this browser.',
  );
  return worker.calls.read(file).finally(() => worker.close());
}
