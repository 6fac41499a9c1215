import { defineProcessingModule } from '@ubii/pm-sandbox';
import type * as Vision from '@ubii/vision';
import {
  BACKEND_INPUT,
  BACKEND_OUTPUTS,
  IMAGE_INPUT,
  MAX_RATE_INPUT,
  TIME_OUTPUTS,
} from '../image-io.ts';
import type { NumberRecord } from '../number-record.ts';

/** State of an instance. */
interface PoseState {
  choice: Vision.ModelChoice<'movenet', Vision.BodyPoseDetector> | undefined;
  /** The last outputs. */
  backendFault: string | undefined;
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
  version: '1.1.0',
  assets: ['vision', 'tfjs-wasm', 'movenet-lightning'],
  inputs: {
    image: IMAGE_INPUT,
    minScore: {
      format: 'double',
      default: 0.3,
      description: 'Keypoints below this score are left out, 0 to 1.',
    },
    smoothingMs: {
      format: 'double',
      default: 80,
      description: 'Smoothing time constant, 0 to 10 000 ms; 0 turns smoothing off.',
    },
    maxRate: { ...MAX_RATE_INPUT, default: 15 },
    backend: BACKEND_INPUT,
  },
  outputs: {
    keypoints: {
      format: 'object2DList',
      description: 'Keypoints by name, 0 to 1 of width and height, each with its score.',
    },
    score: {
      format: 'double',
      description: 'Mean score of all keypoints, 0 to 1; below 0.2, a body is unlikely.',
    },
    ...TIME_OUTPUTS,
    ...BACKEND_OUTPUTS,
    error: {
      format: 'string',
      description: 'Problem with the image or the backend; empty when there is none.',
    },
  },
  mode: { triggerOnInput: {} },
  createState: (): PoseState => ({
    choice: undefined,
    backendFault: undefined,
    smoother: undefined,
    smoothingMs: -1,
    sinceMs: Infinity,
    error: '',
  }),
  async onCreated(state) {
    const vision = state.modules['vision'] as typeof Vision;
    state.choice = await vision.ModelChoice.create({
      tensorflow: state.assets['tfjs-wasm']!,
      previousFault: state.previousFault,
      models: {
        movenet: {
          title: 'MoveNet',
          load: () => state.assets['movenet-lightning']!,
          create: (tensorflow, files) => vision.createBodyPose(tensorflow, files),
        },
      },
      // eslint-disable-next-line no-console -- the log of the module
      onChange: (text) => console.info(text),
    });
  },
  async onProcessing(deltaTimeMs, inputs, state) {
    const number = (record: NumberRecord | undefined, fallback: number): number => {
      const value = record?.double ?? record?.float ?? record?.int32;
      return Number.isFinite(value) ? value! : fallback;
    };
    state.sinceMs += deltaTimeMs;
    const { choice } = state;
    if (choice === undefined) return undefined;
    choice.choose('movenet', inputs.backend?.string || 'auto');
    const image = inputs.image?.image2D;
    const timestamp = inputs.image?.timestamp;
    const triggers = state.inputTriggerNames;
    // A parameter that changes counts for the next image.
    const isNew = triggers === undefined || triggers.includes('image');
    if (image === undefined || !isNew) return undefined;
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
    let error: string;
    let pose: Vision.BodyPose | undefined;
    try {
      const picture = await vision.readImage2D(image);
      decodedMs = performance.now();
      const found = await choice.use((model) => model.detect(picture));
      pose = state.smoother.smooth(found, sinceMs);
      error = choice.problem;
    } catch (thrown) {
      // Advice for the sender of the image.
      if (!(thrown instanceof RangeError)) throw thrown;
      error = thrown.message;
    }
    const isNewError = error !== state.error;
    state.error = error;
    if (pose === undefined)
      return isNewError ? { outputs: { error: { string: error } } } : undefined;
    const { backend, backendFault } = choice;
    const isNewFault = backendFault !== state.backendFault;
    state.backendFault = backendFault;
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
        backend: { string: backend },
        backendFault: isNewFault ? { string: backendFault } : undefined,
        error: isNewError ? { string: error } : undefined,
      },
    };
  },
  onDestroyed(state) {
    state.choice?.dispose();
  },
});
