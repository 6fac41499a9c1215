import type { Clock } from '@ubii/timing';
import type { Log, Recorder, ReplayFiles } from '../../core/ports/index.ts';
import { DiskFolder } from '@ubii/recording/node';
import { recordHere, type RecorderLimits } from '@ubii/recording/recorder';
import { recordOnThread, type CheckLimits } from '@ubii/recording/thread';
import { FolderReplays } from '../../core/replayer/folder-replays.ts';
import { WorkerReplayFiles } from './worker-replay-files.ts';

export interface RecordingOptions {
  /** Path of the folder of the recordings. */
  readonly folder: string;
  readonly limits: RecorderLimits & CheckLimits & { readonly recorderQueueBytes: number };
  readonly clock: Clock;
  readonly log: Log;
  /** The built threads, and the process of the first; undefined: this thread does their work. */
  readonly recorderWorkerFile: URL | undefined;
  readonly checkProcessFile: URL | undefined;
  readonly replayWorkerFile: URL | undefined;
}

/** Opens the recordings of a master: to be written and to be played, each on a thread of its own. */
export function openRecordings(options: RecordingOptions): {
  readonly recorder: Recorder;
  readonly replayFiles: ReplayFiles;
} {
  const { folder, clock, log, limits } = options;
  const { recorderWorkerFile, checkProcessFile, replayWorkerFile } = options;
  const here = { folder: new DiskFolder(folder), clock };
  const onThread = { folder, clock, log };
  return {
    recorder:
      recorderWorkerFile === undefined || checkProcessFile === undefined
        ? recordHere({ ...here, limits })
        : recordOnThread({
            folder,
            clock,
            limits,
            checkProcessFile,
            workerFile: recorderWorkerFile,
            onFailure: (what, reason) => log.error(what, { reason }),
          }),
    replayFiles:
      replayWorkerFile === undefined
        ? new FolderReplays(here)
        : new WorkerReplayFiles({ ...onThread, workerFile: replayWorkerFile }),
  };
}
