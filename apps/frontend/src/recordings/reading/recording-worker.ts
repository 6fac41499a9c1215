import { RecordingReader } from '@ubii/recording';
import { BlobSource, RangeSource } from '@ubii/recording/browser';
import { systemClock } from '@ubii/timing/system';
import { RecordingDesk, sentenceOf, type Tell } from './recording-desk.ts';
import type { RecordingCommand } from './recording-messages.ts';

/** Reads one recording beside the page. */
const tell: Tell = (report, transfer = []) => self.postMessage(report, { transfer });
let desk: RecordingDesk | undefined;

const turns = {
  nowMs: () => performance.now(),
  pause: () => new Promise<void>((resolve) => void setTimeout(resolve)),
};

async function open(source: Blob | string): Promise<void> {
  const from = typeof source === 'string' ? new RangeSource(source) : new BlobSource(source);
  desk = new RecordingDesk(await RecordingReader.open(from), systemClock, tell);
  await desk.begin(turns);
}

self.addEventListener('message', ({ data }: MessageEvent<RecordingCommand>) => {
  const work = data.kind === 'open' ? open(data.source) : desk?.handle(data);
  work?.catch((error: unknown) => tell({ kind: 'failed', message: sentenceOf(error) }));
});
