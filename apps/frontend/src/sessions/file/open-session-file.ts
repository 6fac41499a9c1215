import { FILE_LIMITS } from './file-limits.ts';
import { readSessionFile, refuseSize, type ReadFile } from './read-session-file.ts';

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

function readInWorker(file: File): Promise<ReadFile> {
  const worker = new Worker(new URL('./session-file-worker.ts', import.meta.url), {
    type: 'module',
  });
  return new Promise<ReadFile>((resolve, reject) => {
    worker.onmessage = ({ data }: MessageEvent<ReadFile>) => resolve(data);
    worker.onerror = () => reject(new Error('it is too large for this browser.'));
    worker.postMessage(file);
  }).finally(() => worker.terminate());
}
