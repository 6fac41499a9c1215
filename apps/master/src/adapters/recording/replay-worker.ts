import { workerData } from 'node:worker_threads';
import { ServiceError } from '@ubii/proto';
import { DiskFolder } from '@ubii/recording/node';
import { SystemClock } from '@ubii/timing/system';
import { serveThread, transfer } from '@ubii/worker-rpc/node';

import type { ReplayFile, ReplayPlayer } from '../../core/ports/index.ts';
import { FolderReplays } from '../../core/replayer/folder-replays.ts';
import type { ReplayOwner, ReplayThread, ReplayThreadData } from './replay-messages.ts';

/* The thread that reads and paces recordings, apart from the one that records. [RP-15] */
const { folder } = workerData as ReplayThreadData;
const replays = new FolderReplays({ folder: new DiskFolder(folder), clock: new SystemClock() });
const files = new Map<number, ReplayFile>();
const players = new Map<number, ReplayPlayer>();

const owner = serveThread<ReplayThread, ReplayOwner>(
  {
    async open(file, recordingId) {
      const opened = await replays.open(recordingId);
      files.set(file, opened);
      return opened.facts;
    },
    session: async (file, id, timeNs) => require(files, file).session(id, timeNs),
    devices: async (file, span) => require(files, file).devices(span),
    async play(file, player, part) {
      const played = require(files, file).play(part, {
        // The frame has memory of its own.
        onBatch: (batch) => owner.publish(player, transfer(batch, [batch.frame.buffer])),
        onState: (state) => void owner.showState(player, state),
        onLost: () => undefined, // Players of a folder are not lost.
      });
      players.set(player, played);
    },
    do: async (player, command) => require(players, player).do(command),
    async closePlayer(player) {
      players.get(player)?.close();
      players.delete(player);
    },
    async close(file) {
      const opened = files.get(file);
      files.delete(file);
      await opened?.close();
    },
  },
  { asError: ServiceError.from },
);

function require<T>(known: ReadonlyMap<number, T>, number: number): T {
  const found = known.get(number);
  if (found === undefined) throw new ServiceError('unavailable', 'The replay has ended.');
  return found;
}
