import { RecordingReader } from '@ubii/recording';
import { systemClock } from '@ubii/timing/system';
import { serveCalls } from '@ubii/worker-rpc/browser';
import { openSource } from '../files/open-source.ts';
import type { ReadableFile } from '../files/readable-file.ts';
import { ReadTurns } from './read-turns.ts';
import { RecordingDesk } from './recording-desk.ts';
import type { RecordingPage, RecordingWorker } from './recording-messages.ts';

/** Reads one recording beside the page. Before it is open, calls do nothing. */
const page: RecordingPage = serveCalls<RecordingWorker, RecordingPage>({
  open,
  reopen,
  readTiles: async (request) => desk?.readTiles(request),
  readFrame: async (topic, timeMs) => desk?.readFrame(topic, timeMs),
  play: async () => desk?.play(),
  pause: async () => desk?.pause(),
  setRate: async (rate) => desk?.setRate(rate),
  setLoop: async (loop) => desk?.setLoop(loop),
  seek: async (timeMs) => desk?.seek(timeMs),
  stepRecord: async (topic, direction) => desk?.stepRecord(topic, direction),
  stepTime: async (deltaMs) => desk?.stepTime(deltaMs),
});
let desk: RecordingDesk | undefined;

const pause = (ms = 0): Promise<void> =>
  new Promise<void>((resolve) => void setTimeout(resolve, ms));
const turns = new ReadTurns({ nowMs: () => performance.now(), pause, wait: pause });

let source: ReadableFile = new Blob();

async function openDesk(): Promise<RecordingDesk> {
  const reader = await RecordingReader.open(openSource(source));
  return new RecordingDesk(reader, systemClock, turns, page);
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
