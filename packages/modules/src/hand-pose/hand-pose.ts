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
interface HandState {
  choice: Vision.ModelChoice<'hands', Vision.HandPoseDetector> | undefined;
  /** The last outputs. */
  backendFault: string | undefined;
  /** Milliseconds from the start of the last detection to now. */
  sinceMs: number;
  error: string;
}

/** Finds hands and their keypoints in images, with Handtrack and MediaPipe's hand landmarks. */
export const handPose = defineProcessingModule({
  name: 'hand-pose',
  description: 'Finds the 21 keypoints of hands in images.',
  tags: ['image', 'vision', 'pose'],
  authors: ['Ubi-Interact'],
  version: '1.1.0',
  assets: ['vision', 'tfjs-wasm', 'hand-pose'],
  inputs: {
    image: IMAGE_INPUT,
    threshold: {
      format: 'double',
      default: 0.5,
      description: 'Hands below this score are left out, 0 to 1.',
    },
    maxHands: {
      format: 'double',
      default: 2,
      description: 'Most hands, 1 to 10: those with the highest scores.',
    },
    maxRate: { ...MAX_RATE_INPUT, default: 10 },
    backend: BACKEND_INPUT,
  },
  outputs: {
    keypoints: {
      format: 'object2DList',
      description:
        'Keypoints such as left.thumbTip, 0 to 1 of width and height, with the score of the hand.',
    },
    positions: {
      format: 'object3DList',
      description:
        'The same keypoints in metres from the middle of the hand: x right, y down, z away from the camera.',
    },
    hands: { format: 'double', description: 'Number of hands.' },
    ...TIME_OUTPUTS,
    ...BACKEND_OUTPUTS,
    error: {
      format: 'string',
      description: 'Problem with the image or the backend; empty when there is none.',
    },
  },
  mode: { triggerOnInput: {} },
  createState: (): HandState => ({
    choice: undefined,
    backendFault: undefined,
    sinceMs: Infinity,
    error: '',
  }),
  async onCreated(state) {
    const vision = state.modules['vision'] as typeof Vision;
    state.choice = await vision.ModelChoice.create({
      tensorflow: state.assets['tfjs-wasm']!,
      previousFault: state.previousFault,
      models: {
        hands: {
          title: 'Hand landmarks',
          load: () => state.assets['hand-pose']!,
          create: (tensorflow, files) => vision.createHandPose(tensorflow, files),
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
    choice.choose('hands', inputs.backend?.string || 'auto');
    const image = inputs.image?.image2D;
    const timestamp = inputs.image?.timestamp;
    const triggers = state.inputTriggerNames;
    // A parameter that changes counts for the next image.
    const isNew = triggers === undefined || triggers.includes('image');
    if (image === undefined || !isNew) return undefined;
    const rateHz = Math.min(240, Math.max(0.1, number(inputs.maxRate, 10)));
    // Half a millisecond for what timers round.
    if (state.sinceMs + 0.5 < 1000 / rateHz) return undefined;
    state.sinceMs = 0;

    const vision = state.modules['vision'] as typeof Vision;
    const startedMs = performance.now();
    let decodedMs = startedMs;
    let error: string;
    let hands: Vision.HandPose[] | undefined;
    try {
      const picture = await vision.readImage2D(image);
      decodedMs = performance.now();
      const threshold = number(inputs.threshold, 0.5);
      const maxHands = number(inputs.maxHands, 2);
      hands = await choice.use((model) => model.detect(picture, { threshold, maxHands }));
      error = choice.problem;
    } catch (thrown) {
      // Advice for the sender of the image.
      if (!(thrown instanceof RangeError)) throw thrown;
      error = thrown.message;
    }
    const isNewError = error !== state.error;
    state.error = error;
    if (hands === undefined)
      return isNewError ? { outputs: { error: { string: error } } } : undefined;
    const { backend, backendFault } = choice;
    const isNewFault = backendFault !== state.backendFault;
    state.backendFault = backendFault;
    const points = hands.flatMap(({ side, score, keypoints }, hand) =>
      keypoints.map(({ name, x, y, metric }) => ({
        id: `${side}.${name}`,
        userDataJson: JSON.stringify({ hand, score: Math.round(score * 100) / 100 }),
        place: { x, y },
        metric,
      })),
    );
    return {
      outputs: {
        keypoints: {
          timestamp,
          object2DList: {
            elements: points.map(({ id, userDataJson, place }) => ({
              id,
              userDataJson,
              pose: { position: place },
            })),
          },
        },
        positions: {
          timestamp,
          object3DList: {
            elements: points.map(({ id, userDataJson, metric }) => ({
              id,
              userDataJson,
              pose: { position: metric },
            })),
          },
        },
        hands: { double: hands.length },
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
