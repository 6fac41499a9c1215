import { defineProcessingModule } from '@ubii/pm-sandbox';
import type * as Vision from '@ubii/vision';
import type { NumberRecord } from '../number-record.ts';

/** What an instance keeps. */
interface PoseState {
  detector: Vision.BodyPoseDetector | undefined;
  smoother: Vision.PoseSmoother | undefined;
  smoothingMs: number;
  /** Milliseconds from the start of the last detection to now. */
  sinceMs: number;
  error: string;
}

/** Finds the keypoints of the most visible body in images, with MoveNet Lightning on TensorFlow.js. */
export const bodyPose = defineProcessingModule({
  name: 'body-pose',
  description: 'Finds the 17 keypoints of a body in images.',
  tags: ['image', 'vision', 'pose'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  assets: ['vision', 'tfjs-wasm', 'movenet-lightning'],
  inputs: {
    image: 'image2D',
    minScore: { format: 'double', default: 0.3 },
    smoothingMs: { format: 'double', default: 80 },
    maxRate: { format: 'double', default: 15 },
  },
  outputs: {
    keypoints: 'object2DList',
    score: 'double',
    decodeMs: 'double',
    durationMs: 'double',
    error: 'string',
  },
  mode: { triggerOnInput: {} },
  createState: (): PoseState => ({
    detector: undefined,
    smoother: undefined,
    smoothingMs: -1,
    sinceMs: Infinity,
    error: '',
  }),
  async onCreated(state) {
    const vision = state.modules['vision'] as typeof Vision;
    const tensorflow = await vision.sharedTensorflow(state.assets['tfjs-wasm']!);
    state.detector = await vision.createBodyPose(tensorflow, state.assets['movenet-lightning']!);
    // eslint-disable-next-line no-console -- the log of the module
    console.info(`TensorFlow.js uses ${tensorflow.backend}. ${tensorflow.reason}`);
  },
  async onProcessing(deltaTimeMs, inputs, state) {
    const number = (record: NumberRecord | undefined, fallback: number): number => {
      const value = record?.double ?? record?.float ?? record?.int32;
      return Number.isFinite(value) ? value! : fallback;
    };
    state.sinceMs += deltaTimeMs;
    const image = inputs.image?.image2D;
    const timestamp = inputs.image?.timestamp;
    const triggers = state.inputTriggerNames;
    // A parameter that changes counts for the next image.
    const isNew = triggers === undefined || triggers.includes('image');
    if (image === undefined || !isNew || state.detector === undefined) return undefined;
    const rateHz = Math.min(240, Math.max(0.1, number(inputs.maxRate, 15)));
    // Half a millisecond for what timers round.
    if (state.sinceMs + 0.5 < 1000 / rateHz) return undefined;
    const sinceMs = state.sinceMs;
    state.sinceMs = 0;

    const vision = state.modules['vision'] as typeof Vision;
    const smoothingMs = Math.min(10_000, Math.max(0, number(inputs.smoothingMs, 80)));
    if (state.smoother === undefined || state.smoothingMs !== smoothingMs) {
      state.smoother = new vision.PoseSmoother({ timeConstantMs: smoothingMs });
      state.smoothingMs = smoothingMs;
    }
    const startedMs = performance.now();
    let decodedMs = startedMs;
    let error = '';
    let pose: Vision.BodyPose | undefined;
    try {
      const picture = await vision.readImage2D(image);
      decodedMs = performance.now();
      const found = await state.detector.detect(picture);
      pose = state.smoother.smooth(found, sinceMs);
    } catch (thrown) {
      // What the sender of the image has to change.
      if (!(thrown instanceof RangeError)) throw thrown;
      error = thrown.message;
    }
    const isNewError = error !== state.error;
    state.error = error;
    if (pose === undefined)
      return isNewError ? { outputs: { error: { string: error } } } : undefined;
    const minScore = Math.min(1, Math.max(0, number(inputs.minScore, 0.3)));
    return {
      outputs: {
        keypoints: {
          object2DList: vision.object2DListOfKeypoints(pose.keypoints, minScore),
          timestamp,
        },
        score: { double: pose.score },
        decodeMs: { double: decodedMs - startedMs },
        durationMs: { double: performance.now() - startedMs },
        error: isNewError ? { string: '' } : undefined,
      },
    };
  },
  onDestroyed(state) {
    state.detector?.dispose();
  },
});
