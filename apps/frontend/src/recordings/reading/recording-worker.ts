import { RecordingReader } from '@ubii/recording';
import { systemClock } from '@ubii/timing/system';
import { openSource } from '../files/open-source.ts';
import type { ReadableFile } from '../files/readable-file.ts';
import { ReadTurns } from './read-turns.ts';
import { RecordingDesk, sentenceOf, type Tell } from './recording-desk.ts';
import type { RecordingCommand } from './recording-messages.ts';

/** Reads one recording beside the page. */
const tell: Tell = (report, transfer = []) => self.postMessage(report, { transfer });
let desk: RecordingDesk | undefined;

const pause = (ms = 0): Promise<void> =>
  new Promise<void>((resolve) => void setTimeout(resolve, ms));
const turns = new ReadTurns({ nowMs: () => performance.now(), pause, wait: pause });

let source: ReadableFile = new Blob();

async function openDesk(): Promise<RecordingDesk> {
  const reader = await RecordingReader.open(openSource(source));
  return new RecordingDesk(reader, systemClock, turns, tell);
}

async function open(from: ReadableFile): Promise<void> {
  source = from;
  desk = await openDesk();
  await desk.begin();
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
