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

let source: Blob | string = '';

async function openDesk(): Promise<RecordingDesk> {
  const from = typeof source === 'string' ? new RangeSource(source) : new BlobSource(source);
  return new RecordingDesk(await RecordingReader.open(from), systemClock, tell);
}

async function open(from: Blob | string): Promise<void> {
  source = from;
  desk = await openDesk();
  await desk.begin(turns);
}

async function reopen(): Promise<void> {
  const before = desk;
  const next = await openDesk();
  // It may have been opened again meanwhile
  if (before === undefined || before !== desk) return;
  desk = next;
  before.close();
  await next.resume(before.state);
}

function handle(command: RecordingCommand): Promise<void> | undefined {
  if (command.kind === 'open') return open(command.source);
  return command.kind === 'reopen' ? reopen() : desk?.handle(command);
}

self.addEventListener('message', ({ data }: MessageEvent<RecordingCommand>) => {
  handle(data)?.catch((error: unknown) => tell({ kind: 'failed', message: sentenceOf(error) }));
});
