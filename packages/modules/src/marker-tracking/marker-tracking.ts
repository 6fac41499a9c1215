import { defineProcessingModule } from '@ubii/pm-sandbox';
import type * as Vision from '@ubii/vision';
import { DICTIONARY_NAMES } from '@ubii/vision/choices';
import { IMAGE_INPUT, MAX_RATE_INPUT, TIME_OUTPUTS } from '../image-io.ts';
import type { NumberRecord } from '../number-record.ts';

/** State of an instance. */
interface MarkerState {
  tracker: Vision.MarkerTracker | undefined;
  /** The text that `calibration` was read from. */
  calibrationJson: string;
  calibration: Vision.CameraCalibration | undefined;
  hasToldAssumption: boolean;
  /** Milliseconds from the start of the last detection to now. */
  sinceMs: number;
  error: string;
}

/** Finds ArUco markers and AprilTags in images, with their poses, by OpenCV. */
export const markerTracking = defineProcessingModule({
  name: 'marker-tracking',
  description: 'Finds printed markers and their poses.',
  tags: ['image', 'vision', 'pose'],
  authors: ['Ubi-Interact'],
  version: '1.1.0',
  assets: ['vision', 'opencv'],
  inputs: {
    image: IMAGE_INPUT,
    dictionary: {
      format: 'string',
      default: 'aruco_4x4_50',
      description: 'Family of the printed markers.',
      choices: DICTIONARY_NAMES,
    },
    markerSize: {
      format: 'double',
      default: 0.05,
      description: 'Side with the black border, 0.001 to 100 m.',
    },
    ids: {
      format: 'int32List',
      description: 'Ids of the markers to look for; empty: all of the dictionary.',
    },
    calibration: {
      format: 'string',
      description: 'Calibration of the camera as JSON, as output by camera-calibration.',
    },
    fieldOfView: {
      format: 'double',
      default: 60,
      description:
        'Angle of the longer side of an image, 10 to 150°; used without a calibration only.',
    },
    smoothingMs: {
      format: 'double',
      default: 0,
      description: 'Smoothing time constant, 0 to 10 000 ms; 0 turns smoothing off.',
    },
    maxRate: { ...MAX_RATE_INPUT, default: 30 },
  },
  outputs: {
    markers: {
      format: 'object3DList',
      description:
        'Markers with their pose in the frame of the camera, in metres; y is up, z towards the viewer.',
    },
    outlines: {
      format: 'object2DList',
      description:
        'The same markers in the image, 0 to 1 of width and height: box, corners and axes.',
    },
    ...TIME_OUTPUTS,
    error: {
      format: 'string',
      description:
        'Problem with the image, the calibration or a parameter; empty when there is none.',
    },
  },
  mode: { triggerOnInput: {} },
  createState: (): MarkerState => ({
    tracker: undefined,
    calibrationJson: '',
    calibration: undefined,
    hasToldAssumption: false,
    sinceMs: Infinity,
    error: '',
  }),
  async onCreated(state) {
    const vision = state.modules['vision'] as typeof Vision;
    const factory = state.modules['opencv'] as Vision.OpenCvFactory;
    state.tracker = await vision.createMarkerTracker(
      vision.sharedOpenCv(factory, state.assets['opencv']!),
    );
  },
  async onProcessing(deltaTimeMs, inputs, state) {
    const number = (record: NumberRecord | undefined, fallback: number): number => {
      const value = record?.double ?? record?.float ?? record?.int32;
      return Number.isFinite(value) ? value! : fallback;
    };
    const clamp = (value: number, min: number, max: number): number =>
      Math.min(max, Math.max(min, value));
    state.sinceMs += deltaTimeMs;
    const image = inputs.image?.image2D;
    const timestamp = inputs.image?.timestamp;
    const triggers = state.inputTriggerNames;
    // A parameter that changes counts for the next image.
    const isNew = triggers === undefined || triggers.includes('image');
    if (image === undefined || !isNew || state.tracker === undefined) return undefined;
    const rateHz = clamp(number(inputs.maxRate, 30), 0.1, 240);
    // Half a millisecond for what timers round.
    if (state.sinceMs + 0.5 < 1000 / rateHz) return undefined;
    const sinceMs = state.sinceMs;
    state.sinceMs = 0;

    const vision = state.modules['vision'] as typeof Vision;
    const startedMs = performance.now();
    let decodedMs = startedMs;
    const fieldOfViewDegrees = clamp(number(inputs.fieldOfView, 60), 10, 150);
    let error = '';
    let found: Vision.TrackedMarker[] | undefined;
    try {
      const json = inputs.calibration?.string ?? '';
      if (json !== state.calibrationJson) {
        state.calibration = json === '' ? undefined : vision.parseCalibration(json);
        state.calibrationJson = json;
      }
      if (state.calibration === undefined && !state.hasToldAssumption) {
        state.hasToldAssumption = true;
        // eslint-disable-next-line no-console -- the log of the module
        console.info(
          `There is no calibration: a field of view of ${fieldOfViewDegrees}° and no distortion are assumed, so distances may be wrong. Calibrate the camera.`,
        );
      }
      const picture = await vision.readImage2D(image);
      decodedMs = performance.now();
      found = await state.tracker.track(picture, {
        dictionary: inputs.dictionary?.string || 'aruco_4x4_50',
        sizeMetres: clamp(number(inputs.markerSize, 0.05), 0.001, 100),
        ids: inputs.ids?.int32List.elements ?? [],
        smoothingMs: clamp(number(inputs.smoothingMs, 0), 0, 10_000),
        calibration: state.calibration,
        fieldOfViewDegrees,
        sinceMs,
      });
    } catch (thrown) {
      // Errors that the sender of the image or of a parameter can correct.
      if (!(thrown instanceof RangeError)) throw thrown;
      error = thrown.message;
    }
    const isNewError = error !== state.error;
    state.error = error;
    if (found === undefined)
      return isNewError ? { outputs: { error: { string: error } } } : undefined;
    return {
      outputs: {
        markers: { object3DList: vision.object3DListOfMarkers(found), timestamp },
        outlines: { object2DList: vision.object2DListOfMarkers(found), timestamp },
        decodeMs: { double: decodedMs - startedMs },
        durationMs: { double: performance.now() - startedMs },
        error: isNewError ? { string: '' } : undefined,
      },
    };
  },
  onDestroyed(state) {
    state.tracker?.dispose();
  },
});
