export { openThread, type ThreadOptions } from './open-thread.ts';
export { WorkerRecorder, type WorkerRecorderOptions } from './worker-recorder.ts';
