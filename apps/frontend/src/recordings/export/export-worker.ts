import { RecordingReader } from '@ubii/recording';
import { serveCalls } from '@ubii/worker-rpc/browser';
import { openSource } from '../files/open-source.ts';
import { runExport } from './export-job.ts';
import type { ExportedFile, ExportPage, ExportWorker } from './export-messages.ts';
import { openHandle, openMemory } from './output.ts';

/** Exports one recording beside the page. */
const abort = new AbortController();
const page: ExportPage = serveCalls<ExportWorker, ExportPage>({
  run,
  cancel: async () => abort.abort(new Error('Cancelled.')),
});

async function run(
  ...[source, request, handle]: Parameters<ExportWorker['run']>
): Promise<ExportedFile> {
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
      onProgress: (share) => page.showProgress(share),
      video: () => import('./video.ts'),
    });
    const parts = request.format === 'mcap' && shared ? shared.leftOut : [];
    return {
      file: await file.end(),
      leftOut: [...leftOut, ...parts, ...(shared?.report() ?? [])],
      key: shared?.key(),
    };
  } catch (error) {
    await file.abort();
    throw error;
  }
}
