import { parentPort, workerData } from 'node:worker_threads';
import { ServiceError } from '@ubii/proto';
import { SystemClock } from '@ubii/timing/system';
import { DiskFolder } from '../node/disk-folder.ts';
import { RecorderEngine } from '../recorder/recorder-engine.ts';
import type { FlightSnapshot } from '../recorder/flight-recorder.ts';
import { ProcessChecker } from './process-checker.ts';
import type { FromThread, RecorderThreadData, SnapshotPart, ToThread } from './thread-messages.ts';

type FlightLists = { -readonly [Name in keyof SnapshotPart]: SnapshotPart[Name][number][] };

/* The thread that writes recordings, of records that it reads in shared memory. [RC-50] */
const { folder, limits, checkProcessFile } = workerData as RecorderThreadData;
const clock = new SystemClock();
const processFile = new URL(checkProcessFile);
const recorder = new RecorderEngine({
  ...{ folder: new DiskFolder(folder), clock, limits },
  checker: new ProcessChecker({ processFile, folder, limits, clock }),
});
const send = (message: FromThread): void => parentPort!.postMessage(message);
/** Lists of the snapshot that is kept next. */
let parts = noParts();

recorder.onState((state) => send({ kind: 'state', state }));
parentPort!.on('message', (message: ToThread) => {
  switch (message.kind) {
    case 'open':
      return recorder.open(message.memory);
    case 'erase':
      return recorder.erase(message.memory);
    case 'part':
      return takePart(message.part);
    case 'event':
      return recorder.addEvent(message.event, message.targets);
    case 'call':
      return void answer(message);
  }
});

async function answer({ id, method, args }: Extract<ToThread, { kind: 'call' }>): Promise<void> {
  try {
    // The other side calls it by the types of the port.
    const call = recorder[method].bind(recorder) as (...args: unknown[]) => Promise<unknown>;
    send({ kind: 'reply', id, value: await call(...(method === 'keep' ? whole(args) : args)) });
  } catch (error) {
    const { code, message, details, cause } = ServiceError.from(error);
    send({ kind: 'refusal', id, code, message, details, cause: String(cause ?? '') });
  }
}

function noParts(): FlightLists {
  return { channels: [], standing: [], events: [] };
}

function takePart({ channels, standing, events }: SnapshotPart): void {
  parts.channels.push(...channels);
  parts.standing.push(...standing);
  parts.events.push(...events);
}

/** The arguments of `keep`, with the lists that came before. */
function whole([job, snapshot]: readonly unknown[]): readonly unknown[] {
  const kept = { ...(snapshot as FlightSnapshot), ...parts };
  parts = noParts();
  return [job, kept];
}
