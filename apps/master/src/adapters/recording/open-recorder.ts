import type { Recorder } from '../../core/ports/index.ts';
import { RecorderEngine, type RecorderLimits } from '../../core/recorder/recorder-engine.ts';
import { DiskFolder } from './disk-folder.ts';
import { WorkerRecorder, type WorkerRecorderOptions } from './worker-recorder.ts';

/** Opens the recorder of a master: on a thread, or without a built one on this. */
export function openRecorder({
  workerFile,
  ...options
}: Omit<WorkerRecorderOptions, 'workerFile'> & { workerFile: URL | undefined }): Recorder {
  const { recordingsBytes, markersPerRecording } = options.limits;
  const limits: RecorderLimits = { recordingsBytes, markersPerRecording };
  if (workerFile !== undefined) return new WorkerRecorder({ ...options, limits, workerFile });
  const { folder, clock } = options;
  return new RecorderEngine({ folder: new DiskFolder(folder), clock, limits });
}
