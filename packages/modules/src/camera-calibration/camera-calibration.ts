import { defineProcessingModule } from '@ubii/pm-sandbox';
import type * as Vision from '@ubii/vision';
import { DICTIONARY_NAMES } from '@ubii/vision/choices';
import { IMAGE_INPUT } from '../image-io.ts';
import type { NumberRecord } from '../number-record.ts';

/** State of an instance. */
interface CalibrationState {
  calibrator: Vision.CameraCalibrator | undefined;
  /** The board that the calibrator looks for, as JSON. */
  board: string;
  /** Whether the calibration was put out. */
  isDone: boolean;
  hint: string;
  /** Milliseconds from the start of the last look to now. */
  sinceMs: number;
  error: string;
}

/** Collects views of a printed ChArUco board and computes the calibration of a camera, by OpenCV. */
export const cameraCalibration = defineProcessingModule({
  name: 'camera-calibration',
  description: 'Calibrates a camera with a printed board.',
  tags: ['image', 'vision', 'camera'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  assets: ['vision', 'opencv'],
  inputs: {
    image: IMAGE_INPUT,
    startOver: { format: 'bool', description: 'True deletes all views and starts again.' },
    columns: {
      format: 'double',
      default: 5,
      description: 'Squares in a row of the board, 3 to 16.',
    },
    rows: { format: 'double', default: 7, description: 'Rows of squares, 3 to 16.' },
    squareSize: { format: 'double', default: 0.032, description: 'Side of a square, up to 10 m.' },
    markerSize: {
      format: 'double',
      default: 0.024,
      description: 'Side of a marker in metres, less than squareSize.',
    },
    dictionary: {
      format: 'string',
      default: 'aruco_5x5_50',
      description: 'Family of the markers on the board.',
      choices: DICTIONARY_NAMES,
    },
    maxRate: {
      format: 'double',
      default: 5,
      description: 'Most images per second, 0.1 to 30; images in between are dropped.',
    },
  },
  outputs: {
    calibration: {
      format: 'string',
      description: 'Calibration as JSON, once all views are taken; input of marker-tracking.',
    },
    views: { format: 'double', description: 'Views taken so far, 0 to 12.' },
    hint: { format: 'string', description: 'Next step for the user, one sentence.' },
    corners: {
      format: 'object2DList',
      description: 'Corners between the squares that are seen, 0 to 1 of width and height.',
    },
    error: {
      format: 'string',
      description: 'Problem with the image or the board; empty when there is none.',
    },
  },
  mode: { triggerOnInput: {} },
  createState: (): CalibrationState => ({
    calibrator: undefined,
    board: '',
    isDone: false,
    hint: '',
    sinceMs: Infinity,
    error: '',
  }),
  async onCreated(state) {
    const vision = state.modules['vision'] as typeof Vision;
    const factory = state.modules['opencv'] as Vision.OpenCvFactory;
    // Loaded here, where loading may take longer than a run
    const runtime = vision.sharedOpenCv(factory, state.assets['opencv']!);
    state.calibrator = await vision.createCameraCalibrator(runtime, vision.DEFAULT_BOARD);
    state.board = JSON.stringify(vision.DEFAULT_BOARD);
  },
  async onProcessing(deltaTimeMs, inputs, state) {
    const number = (record: NumberRecord | undefined, fallback: number): number => {
      const value = record?.double ?? record?.float ?? record?.int32;
      return Number.isFinite(value) ? value! : fallback;
    };
    state.sinceMs += deltaTimeMs;
    const vision = state.modules['vision'] as typeof Vision;
    const triggers = state.inputTriggerNames;
    if (triggers?.includes('startOver') && inputs.startOver?.bool === true) {
      state.calibrator?.reset();
      state.isDone = false;
    }
    const image = inputs.image?.image2D;
    const timestamp = inputs.image?.timestamp;
    // A parameter that changes counts for the next image.
    const isNew = triggers === undefined || triggers.includes('image');
    if (image === undefined || !isNew || state.calibrator === undefined) return undefined;
    const rateHz = Math.min(30, Math.max(0.1, number(inputs.maxRate, 5)));
    // Half a millisecond for what timers round.
    if (state.sinceMs + 0.5 < 1000 / rateHz) return undefined;
    state.sinceMs = 0;

    let error = '';
    let look: Vision.CalibrationLook | undefined;
    try {
      const board = {
        columns: Math.round(number(inputs.columns, 5)),
        rows: Math.round(number(inputs.rows, 7)),
        squareMetres: number(inputs.squareSize, 0.032),
        markerMetres: number(inputs.markerSize, 0.024),
        dictionary: inputs.dictionary?.string || 'aruco_5x5_50',
      };
      const text = JSON.stringify(board);
      if (text !== state.board) {
        const factory = state.modules['opencv'] as Vision.OpenCvFactory;
        const runtime = vision.sharedOpenCv(factory, state.assets['opencv']!);
        const next = await vision.createCameraCalibrator(runtime, board);
        state.calibrator.dispose();
        state.calibrator = next;
        state.board = text;
        state.isDone = false;
      }
      look = await state.calibrator.look(await vision.readImage2D(image));
    } catch (thrown) {
      // Errors that the sender of the image or of the board can correct.
      if (!(thrown instanceof RangeError)) throw thrown;
      error = thrown.message;
    }
    const isNewError = error !== state.error;
    state.error = error;
    if (look === undefined)
      return isNewError ? { outputs: { error: { string: error } } } : undefined;
    const { calibration, corners, views, hint } = look;
    const isDone = calibration !== undefined;
    const isNewlyDone = isDone && !state.isDone;
    state.isDone = isDone;
    const isNewHint = hint !== state.hint;
    state.hint = hint;
    return {
      outputs: {
        calibration: isNewlyDone ? { string: JSON.stringify(calibration) } : undefined,
        views: { double: views },
        hint: isNewHint ? { string: hint } : undefined,
        corners: { object2DList: vision.object2DListOfCorners(corners), timestamp },
        error: isNewError ? { string: '' } : undefined,
      },
    };
  },
  onDestroyed(state) {
    state.calibrator?.dispose();
  },
});
