import { defineProcessingModule } from '@ubii/pm-sandbox';
import type * as Vision from '@ubii/vision';
import type { NumberRecord } from '../number-record.ts';

/** What an instance keeps. */
interface DetectionState {
  detector: Vision.Detector | undefined;
  backend: string;
  /** Milliseconds from the start of the last detection to now. */
  sinceMs: number;
  error: string;
}

/** Detects objects of the 80 classes of COCO in images, with CenterNet on TensorFlow.js. */
export const objectDetection = defineProcessingModule({
  name: 'object-detection',
  description: 'Detects objects in images: 80 classes of COCO.',
  tags: ['image', 'vision', 'detection'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  assets: ['vision', 'tfjs-wasm', 'centernet-coco'],
  inputs: {
    image: 'image2D',
    threshold: { format: 'double', default: 0.4 },
    maxObjects: { format: 'double', default: 20 },
    classes: 'stringList',
    inputSize: { format: 'double', default: 384 },
    maxRate: { format: 'double', default: 15 },
  },
  outputs: {
    predictions: 'object2DList',
    durationMs: 'double',
    backend: 'string',
    error: 'string',
  },
  mode: { triggerOnInput: {} },
  createState: (): DetectionState => ({
    detector: undefined,
    backend: '',
    sinceMs: Infinity,
    error: '',
  }),
  async onCreated(state) {
    const vision = state.modules['vision'] as typeof Vision;
    const tensorflow = await vision.sharedTensorflow(state.assets['tfjs-wasm']!);
    state.detector = await vision.createCenterNet(tensorflow, state.assets['centernet-coco']!);
    // eslint-disable-next-line no-console -- the log of the module
    console.info(`TensorFlow.js uses ${tensorflow.backend}. ${tensorflow.reason}`);
    state.backend = tensorflow.backend;
  },
  async onProcessing(deltaTimeMs, inputs, state) {
    const number = (record: NumberRecord | undefined): number | undefined => {
      const value = record?.double ?? record?.float ?? record?.int32;
      return Number.isFinite(value) ? value : undefined;
    };
    state.sinceMs += deltaTimeMs;
    const image = inputs.image?.image2D;
    const timestamp = inputs.image?.timestamp;
    const triggers = state.inputTriggerNames;
    // A parameter that changes counts for the next image.
    const isNew = triggers === undefined || triggers.includes('image');
    if (image === undefined || !isNew || state.detector === undefined) return undefined;
    const rateHz = Math.min(240, Math.max(0.1, number(inputs.maxRate) ?? 15));
    // Half a millisecond for what timers round.
    if (state.sinceMs + 0.5 < 1000 / rateHz) return undefined;
    state.sinceMs = 0;

    const vision = state.modules['vision'] as typeof Vision;
    const startedMs = performance.now();
    let error = '';
    let found: Vision.Detection[] = [];
    try {
      const picture = await vision.readImage2D(image);
      found = await state.detector.detect(picture, {
        threshold: number(inputs.threshold) ?? 0.4,
        maxObjects: number(inputs.maxObjects) ?? 20,
        classes: inputs.classes?.stringList.elements ?? [],
        inputSize: number(inputs.inputSize) ?? 384,
      });
    } catch (thrown) {
      // What the sender of the image, or of the classes, has to change.
      if (!(thrown instanceof RangeError)) throw thrown;
      error = thrown.message;
    }
    const isNewError = error !== state.error;
    state.error = error;
    if (error !== '') return isNewError ? { outputs: { error: { string: error } } } : undefined;
    return {
      outputs: {
        predictions: { object2DList: vision.object2DListOfDetections(found), timestamp },
        durationMs: { double: performance.now() - startedMs },
        backend: { string: state.backend },
        error: isNewError ? { string: '' } : undefined,
      },
    };
  },
  onDestroyed(state) {
    state.detector?.dispose();
  },
});
