import type { Detect } from './detect.ts';
import type { DetectionBackend, LibraryAnswer, LibraryCall } from './library-messages.ts';

/** The library of the detector in a worker of its own, see human-worker.ts. */
export function openLibrary(backend: DetectionBackend): Detect {
  const worker = new Worker('/human-worker.js');
  return async ({ width, height, rgba }) => {
    const answer = await new Promise<LibraryAnswer>((resolve, reject) => {
      worker.onmessage = ({ data }: MessageEvent<LibraryAnswer>) => resolve(data);
      worker.onerror = (event) => reject(new Error(event.message));
      const call: LibraryCall = { backend, width, height, rgba };
      worker.postMessage(call, [rgba.buffer]);
    });
    if ('error' in answer) throw new Error(answer.error);
    return answer.seen;
  };
}
