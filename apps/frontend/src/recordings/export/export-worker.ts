import { RecordingReader } from '@ubii/recording';
import { openSource } from '../files/open-source.ts';
import { sentenceOf } from '../reading/recording-desk.ts';
import { runExport } from './export-job.ts';
import type { ExportCommand, ExportReport } from './export-messages.ts';
import { openHandle, openMemory } from './output.ts';

/** Exports one recording beside the page. */
const tell = (report: ExportReport): void => self.postMessage(report);
const abort = new AbortController();

async function start({
  source,
  request,
  handle,
}: Extract<ExportCommand, { kind: 'export' }>): Promise<void> {
  const whole = await RecordingReader.open(openSource(source));
  const { personal } = request;
  const shared =
    personal && (await (await import('../personal/share-reader.ts')).shareReader(whole, personal));
  const names = request.topics.flatMap((topic) => (shared ? (shared.topic(topic) ?? []) : topic));
  // Topics that differed in a dropped value are one.
  const topics = [...new Set(names)];
  if (topics.length === 0) throw new Error('The labels of personal data drop all of these topics.');
  const file = await (handle ? openHandle(handle) : openMemory());
  try {
    const leftOut = await runExport(shared?.reader ?? whole, { ...request, topics }, file, {
      signal: abort.signal,
      isZip: request.topics.length > 1,
      onProgress: (share) => tell({ kind: 'progress', share }),
      video: () => import('./video.ts'),
    });
    const parts = request.format === 'mcap' && shared ? shared.leftOut : [];
    tell({
      kind: 'done',
      file: await file.end(),
      leftOut: [...leftOut, ...parts, ...(shared?.report() ?? [])],
      key: shared?.key(),
    });
  } catch (error) {
    await file.abort();
    throw error;
  }
}

self.addEventListener('message', ({ data }: MessageEvent<ExportCommand>) => {
  if (data.kind === 'cancel') abort.abort(new Error('Cancelled.'));
  else start(data).catch((error: unknown) => tell({ kind: 'failed', message: sentenceOf(error) }));
});
