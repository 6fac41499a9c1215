import type { CompareReport, CompareRequest } from './compare-messages.ts';

/** Compares two recordings of the master. @returns what cancels it */
export type CompareRecordings = (
  request: CompareRequest,
  onReport: (report: CompareReport) => void,
) => () => void;

/** In a worker of its own. */
export const compareInWorker: CompareRecordings = (request, onReport) => {
  const worker = new Worker(new URL('./compare-worker.ts', import.meta.url), { type: 'module' });
  worker.onmessage = ({ data }: MessageEvent<CompareReport>) => {
    if (data.kind !== 'progress') worker.terminate();
    onReport(data);
  };
  worker.onerror = () =>
    onReport({ kind: 'failed', message: 'This browser cannot compare the recordings.' });
  worker.postMessage(request);
  return () => worker.terminate();
};
