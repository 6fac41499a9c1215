import type { RecordingCommand, RecordingReport } from '../reading/recording-messages.ts';

/** The worker that reads a recording. */
export interface RecordingPort {
  send(command: RecordingCommand): void;
  onReport(handle: (report: RecordingReport) => void): void;
  close(): void;
}

/** Starts a worker of its own for one recording. */
export function openWorker(): RecordingPort {
  const worker = new Worker(new URL('../reading/recording-worker.ts', import.meta.url), {
    type: 'module',
  });
  return {
    send: (command) => worker.postMessage(command),
    onReport(handle) {
      worker.onmessage = ({ data }: MessageEvent<RecordingReport>) => handle(data);
      worker.onerror = () =>
        handle({ kind: 'failed', message: 'This browser cannot read the recording.' });
    },
    close: () => worker.terminate(),
  };
}
