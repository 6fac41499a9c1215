import { parentPort, workerData } from 'node:worker_threads';
import { ServiceError } from '@ubii/proto';
import { SystemClock } from '@ubii/timing/system';
import { DiskFolder } from '../node/disk-folder.ts';
import { RecorderEngine } from '../recorder/recorder-engine.ts';
import type { RecordSource } from '../recorder/recorder.ts';
import { ProcessChecker } from './process-checker.ts';
import type { FromThread, RecorderThreadData, ToThread } from './thread-messages.ts';

/* The thread that records: it holds the last minutes, and writes files. [RC-50] */
const { folder, limits, checkProcessFile } = workerData as RecorderThreadData;
const clock = new SystemClock();
const processFile = new URL(checkProcessFile);
const recorder = new RecorderEngine({
  ...{ folder: new DiskFolder(folder), clock, limits },
  checker: new ProcessChecker({ processFile, folder, limits, clock }),
});
const send = (message: FromThread): void => parentPort!.postMessage(message);
let sources: RecordSource[] = [];

recorder.onState((state) => send({ kind: 'state', state }));
parentPort!.on('message', (message: ToThread) => {
  switch (message.kind) {
    case 'batch':
      return takeBatch(message);
    case 'ended':
      return recorder.endTopics(message.topics);
    case 'event':
      return recorder.addEvent(message.event, message.targets);
    case 'call':
      return void answer(message);
  }
});

function takeBatch({ batch, numbers, added, isFresh }: Extract<ToThread, { kind: 'batch' }>): void {
  if (isFresh) sources = [];
  sources.push(...added);
  const ofBatch = numbers.map((number) => sources[number]!);
  void recorder
    .take({ ...batch, sources: ofBatch })
    .then(() => send({ kind: 'taken', bytes: batch.byteLength }));
}

async function answer({ id, method, args }: Extract<ToThread, { kind: 'call' }>): Promise<void> {
  try {
    // The other side calls it by the types of the port.
    const call = recorder[method].bind(recorder) as (...args: unknown[]) => Promise<unknown>;
    send({ kind: 'reply', id, value: await call(...args) });
  } catch (error) {
    const { code, message, details, cause } = ServiceError.from(error);
    send({ kind: 'refusal', id, code, message, details, cause: String(cause ?? '') });
  }
}
