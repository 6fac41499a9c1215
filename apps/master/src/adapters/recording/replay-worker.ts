import { parentPort, workerData } from 'node:worker_threads';
import { SystemClock } from '@ubii/timing/system';

import { FolderReplays } from '../../core/replayer/folder-replays.ts';
import { DiskFolder } from '@ubii/recording/node';
import { ReplayThread } from './replay-thread.ts';
import type { ReplayThreadData, ToReplayThread } from './replay-messages.ts';

/* The thread that reads and paces recordings, apart from the one that records. [RP-15] */
const { folder } = workerData as ReplayThreadData;
const files = new FolderReplays({ folder: new DiskFolder(folder), clock: new SystemClock() });
const thread = new ReplayThread(files, (message, transfer = []) =>
  parentPort!.postMessage(message, [...transfer]),
);
parentPort!.on('message', (message: ToReplayThread) => thread.handle(message));
