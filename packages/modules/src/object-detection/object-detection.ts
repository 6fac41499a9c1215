import { defineProcessingModule } from '@ubii/pm-sandbox';
import type * as Vision from '@ubii/vision';
import { DETECTOR_NAMES } from '@ubii/vision/choices';
import {
  BACKEND_INPUT,
  BACKEND_OUTPUTS,
  IMAGE_INPUT,
  MAX_RATE_INPUT,
  TIME_OUTPUTS,
} from '../image-io.ts';
import type { NumberRecord } from '../number-record.ts';

/** State of an instance. */
interface DetectionState {
  choice: Vision.DetectorChoice | undefined;
  /** The last outputs. */
  backendFault: string | undefined;
  /** Milliseconds from the start of the last detection to now. */
  sinceMs: number;
  error: string;
}

/** Detects objects of the 80 classes of COCO in images, with CenterNet or COCO-SSD on TensorFlow.js. */
export const objectDetection = defineProcessingModule({
  name: 'object-detection',
  description: 'Detects objects in images: 80 classes of COCO.',
  tags: ['image', 'vision', 'detection'],
  authors: ['Ubi-Interact'],
  version: '1.1.0',
  assets: ['vision', 'tfjs-wasm', 'centernet-coco'],
  optionalAssets: ['coco-ssd'],
  inputs: {
    image: IMAGE_INPUT,
    // Without a value, the detector's own: they differ.
    threshold: {
      format: 'double',
      description:
        'Objects below this score are left out, 0 to 1; unset: 0.4 for centernet, 0.5 for coco-ssd.',
    },
    maxObjects: {
      format: 'double',
      default: 20,
      description: 'Most objects, 1 to 100: those with the highest scores.',
    },
    classes: {
      format: 'stringList',
      description: 'Classes to detect, such as person and cup; empty: all 80 classes of COCO.',
    },
    inputSize: {
      format: 'double',
      description:
        'Longer side in pixels, 128 to 1024, of what the detector sees; smaller is faster and less exact.',
    },
    maxRate: { ...MAX_RATE_INPUT, default: 15 },
    detector: {
      format: 'string',
      default: 'centernet',
      description: 'The model that detects; coco-ssd has to be downloaded first.',
      choices: DETECTOR_NAMES,
    },
    backend: BACKEND_INPUT,
  },
  outputs: {
    predictions: {
      format: 'object2DList',
      description:
        'Objects with class, box from 0 to 1 of the image, and score; the highest score first.',
    },
    belowThreshold: {
      format: 'object2DList',
      description: 'Objects with a score from 0.1 to the threshold, in the same form.',
    },
    ...TIME_OUTPUTS,
    ...BACKEND_OUTPUTS,
    error: {
      format: 'string',
      description: 'Problem with image, classes, detector or backend; empty when there is none.',
    },
  },
  mode: { triggerOnInput: {} },
  createState: (): DetectionState => ({
    choice: undefined,
    backendFault: undefined,
    sinceMs: Infinity,
    error: '',
  }),
  async onCreated(state) {
    const vision = state.modules['vision'] as typeof Vision;
    state.choice = await vision.DetectorChoice.create({
      tensorflow: state.assets['tfjs-wasm']!,
      previousFault: state.previousFault,
      centerNet: state.assets['centernet-coco']!,
      loadCocoSsd: () => state.loadAssets('coco-ssd'),
      // eslint-disable-next-line no-console -- the log of the module
      onChange: (text) => console.info(text),
    });
  },
  async onProcessing(deltaTimeMs, inputs, state) {
    const number = (record: NumberRecord | undefined): number | undefined => {
      const value = record?.double ?? record?.float ?? record?.int32;
      return Number.isFinite(value) ? value : undefined;
    };
    state.sinceMs += deltaTimeMs;
    const { choice } = state;
    if (choice === undefined) return undefined;
    choice.choose(inputs.detector?.string || 'centernet', inputs.backend?.string || 'auto');
    const image = inputs.image?.image2D;
    const timestamp = inputs.image?.timestamp;
    const triggers = state.inputTriggerNames;
    // A parameter that changes counts for the next image.
    const isNew = triggers === undefined || triggers.includes('image');
    if (image === undefined || !isNew) return undefined;
    const rateHz = Math.min(240, Math.max(0.1, number(inputs.maxRate) ?? 15));
    // Half a millisecond for what timers round.
    if (state.sinceMs + 0.5 < 1000 / rateHz) return undefined;
    state.sinceMs = 0;

    const vision = state.modules['vision'] as typeof Vision;
    const startedMs = performance.now();
    let decodedMs = startedMs;
    let error: string;
    let found: Vision.Detection[] | undefined;
    const threshold = Math.min(1, Math.max(0, number(inputs.threshold) ?? choice.defaultThreshold));
    try {
      const picture = await vision.readImage2D(image);
      decodedMs = performance.now();
      found = await choice.detect(picture, {
        // Detections below the threshold are an output, too; scores under 0.1 are noise.
        threshold: Math.min(0.1, threshold),
        maxObjects: number(inputs.maxObjects),
        classes: inputs.classes?.stringList.elements ?? [],
        inputSize: number(inputs.inputSize),
      });
      error = choice.problem;
    } catch (thrown) {
      // Errors that the sender of the image or of the classes can correct.
      if (!(thrown instanceof RangeError)) throw thrown;
      error = thrown.message;
    }
    const isNewError = error !== state.error;
    state.error = error;
    const detections = found;
    if (detections === undefined)
      return isNewError ? { outputs: { error: { string: error } } } : undefined;
    const { backend, backendFault } = choice;
    const isNewFault = backendFault !== state.backendFault;
    state.backendFault = backendFault;
    const listOf = (isIn: (one: Vision.Detection) => boolean): Vision.Object2DListValue =>
      vision.object2DListOfDetections(detections.filter(isIn));
    return {
      outputs: {
        predictions: { object2DList: listOf(({ score }) => score >= threshold), timestamp },
        belowThreshold: { object2DList: listOf(({ score }) => score < threshold), timestamp },
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
