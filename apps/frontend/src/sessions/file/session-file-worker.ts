import { readSessionFile } from './read-session-file.ts';

/** Parses a large file off the main thread. */
self.addEventListener('message', ({ data }: MessageEvent<File>) => {
  void data
    .text()
    .then((text) => self.postMessage(readSessionFile({ name: data.name, text })))
    .catch((cause: unknown) => {
      const reason = cause instanceof Error ? cause.message : String(cause);
      const message = `${data.name} cannot be read: ${reason}`;
      self.postMessage({ kind: 'broken', name: data.name, message, text: undefined });
    });
});
