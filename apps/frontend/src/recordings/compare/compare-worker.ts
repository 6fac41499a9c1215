import { RecordingReader } from '@ubii/recording';
import { openSource } from '../files/open-source.ts';
import { sentenceOf } from '../reading/recording-desk.ts';
import type { CompareReport, CompareRequest } from './compare-messages.ts';
import { compareSession } from './compare-session.ts';

/** Compares two recordings beside the page. */
const tell = (report: CompareReport): void => self.postMessage(report);

async function compare({ recordedFile, rerunFile, ...request }: CompareRequest): Promise<void> {
  const [recorded, rerun] = await Promise.all(
    [recordedFile, rerunFile].map((file) => RecordingReader.open(openSource(file))),
  );
  const comparison = await compareSession(recorded!, rerun!, request, (outputs) =>
    tell({ kind: 'progress', outputs }),
  );
  tell({ kind: 'done', comparison });
}

self.addEventListener('message', ({ data }: MessageEvent<CompareRequest>) => {
  compare(data).catch((error: unknown) => tell({ kind: 'failed', message: sentenceOf(error) }));
});
