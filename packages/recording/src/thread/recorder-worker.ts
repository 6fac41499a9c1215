import { workerData } from 'node:worker_threads';
import { ServiceError, type Recording } from '@ubii/proto';
import { SystemClock } from '@ubii/timing/system';
import { serveThread } from '@ubii/worker-rpc/node';
import { DiskFolder } from '../node/disk-folder.ts';
import { RecorderEngine } from '../recorder/recorder-engine.ts';
import type { FlightSnapshot } from '../recorder/flight-recorder.ts';
import type { RecordingJob } from '../recorder/recorder.ts';
import { ProcessChecker } from './process-checker.ts';
import type {
  RecorderOwner,
  RecorderThread,
  RecorderThreadData,
  SnapshotPart,
} from './thread-messages.ts';

type FlightLists = { -readonly [Name in keyof SnapshotPart]: SnapshotPart[Name][number][] };

const noParts = (): FlightLists => ({ channels: [], standing: [], events: [] });

/** Gets the lists of a snapshot in parts, before the rest of it. */
class PartsRecorder extends RecorderEngine implements RecorderThread {
  #parts = noParts();

  addPart({ channels, standing, events }: SnapshotPart): void {
    this.#parts.channels.push(...channels);
    this.#parts.standing.push(...standing);
    this.#parts.events.push(...events);
  }

  override keep(job: RecordingJob, snapshot: FlightSnapshot): Promise<Recording> {
    const parts = this.#parts;
    this.#parts = noParts();
    return super.keep(job, { ...snapshot, ...parts });
  }
}

/* The thread that writes recordings, of records that it reads in shared memory. [RC-50] */
const { folder, limits, checkProcessFile } = workerData as RecorderThreadData;
const clock = new SystemClock();
const processFile = new URL(checkProcessFile);
const recorder = new PartsRecorder({
  folder: new DiskFolder(folder),
  clock,
  limits,
  checker: new ProcessChecker({ processFile, folder, limits, clock }),
});
const owner = serveThread<RecorderThread, RecorderOwner>(recorder, { asError: ServiceError.from });
recorder.onState((state) => void owner.showState(state));
