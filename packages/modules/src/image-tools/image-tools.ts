import { defineProcessingModule } from '@ubii/pm-sandbox';
import type * as Vision from '@ubii/vision';
import { PIXEL_FORMATS } from '@ubii/vision/choices';
import { IMAGE_INPUT, TIME_OUTPUTS } from '../image-io.ts';
import type { NumberRecord } from '../number-record.ts';

/** State of an instance. */
interface ToolState {
  /** The last image as it was put out, for motion. */
  before: Vision.Picture | undefined;
  error: string;
}

/** Crops, scales and converts images, and measures motion and brightness in them. */
export const imageTools = defineProcessingModule({
  name: 'image-tools',
  description: 'Crops, scales, converts and measures images.',
  tags: ['image', 'vision', 'filter'],
  authors: ['Ubi-Interact'],
  version: '1.1.0',
  assets: ['vision'],
  inputs: {
    image: IMAGE_INPUT,
    x: { format: 'double', default: 0, description: 'Left edge of the part, 0 to 1 of the width.' },
    y: { format: 'double', default: 0, description: 'Top edge of the part, 0 to 1 of the height.' },
    width: { format: 'double', default: 1, description: 'Width of the part, 0 to 1 of the width.' },
    height: {
      format: 'double',
      default: 1,
      description: 'Height of the part, 0 to 1 of the height.',
    },
    maxSide: {
      format: 'double',
      default: 0,
      description:
        'Longest side, 0 to 16 384 pixels; larger images are scaled down, 0 keeps the size.',
    },
    format: {
      format: 'string',
      default: '',
      description: 'Pixel format of the output; empty keeps that of the input.',
      choices: PIXEL_FORMATS,
    },
    bins: {
      format: 'double',
      default: 16,
      description: 'Brightness ranges of the histogram, 1 to 256.',
    },
    motionThreshold: {
      format: 'double',
      default: 0.1,
      description: 'Change of brightness, 0 to 1, from which on a pixel counts as changed.',
    },
  },
  outputs: {
    image: { format: 'image2D', description: 'The part of the image as raw pixels.' },
    motion: {
      format: 'double',
      description: 'Mean change of brightness since the image before, 0 to 1.',
    },
    changed: { format: 'double', description: 'Share of the pixels that changed, 0 to 1.' },
    histogram: {
      format: 'doubleList',
      description:
        'Share of the pixels in each range of brightness, from dark to bright; the sum is 1.',
    },
    ...TIME_OUTPUTS,
    error: {
      format: 'string',
      description: 'Problem with the image or a parameter; empty when there is none.',
    },
  },
  mode: { triggerOnInput: {} },
  createState: (): ToolState => ({ before: undefined, error: '' }),
  async onProcessing(_deltaTimeMs, inputs, state) {
    const faults: string[] = [];
    const number = (
      name: keyof typeof inputs & string,
      fallback: number,
      min: number,
      max: number,
    ): number => {
      const record = inputs[name] as NumberRecord | undefined;
      const value = record?.double ?? record?.float ?? record?.int32;
      if (value === undefined) return fallback;
      const used = Number.isFinite(value) ? Math.min(max, Math.max(min, value)) : fallback;
      if (used !== value)
        faults.push(`${name} is ${min} to ${max}, not ${value}; ${used} is used.`);
      return used;
    };
    const image = inputs.image?.image2D;
    const timestamp = inputs.image?.timestamp;
    const triggers = state.inputTriggerNames;
    // A parameter that changes counts for the next image.
    if (image === undefined || (triggers !== undefined && !triggers.includes('image')))
      return undefined;
    const vision = state.modules['vision'] as typeof Vision;
    const formats = vision.PIXEL_FORMATS;
    const wanted = inputs.format?.string ?? '';
    const bins = Math.round(number('bins', 16, 1, 256));
    const motionThreshold = number('motionThreshold', 0.1, 0, 1);
    const startedMs = performance.now();
    let decodedMs = startedMs;
    let error: string | undefined;
    let picture: Vision.Picture | undefined;
    try {
      const format = formats.find((one) => one === wanted);
      if (format === undefined && wanted !== '')
        throw new RangeError(`The format is ${formats.join(', ')} or empty, not "${wanted}".`);
      picture = await vision.readImage2D(image);
      decodedMs = performance.now();
      const [x, y] = [number('x', 0, 0, 1), number('y', 0, 0, 1)];
      const [wide, high] = [number('width', 1, 0, 1), number('height', 1, 0, 1)];
      const said = (names: object, end: number, range: string): string[] =>
        Object.entries(names).flatMap(([name, value]) =>
          value === end ? `${name} is ${range}, not ${end}` : [],
        );
      const outside = [
        ...said({ x, y }, 1, '0 to below 1'),
        ...said({ width: wide, height: high }, 0, 'above 0 to 1'),
      ];
      if (outside.length > 0)
        throw new RangeError(`The part is outside of the picture: ${outside.join('; ')}.`);
      const part = {
        x: x * picture.width,
        y: y * picture.height,
        width: wide * picture.width,
        height: high * picture.height,
      };
      const isWhole = part.width === picture.width && part.height === picture.height;
      if (!isWhole || part.x > 0 || part.y > 0) picture = vision.cropPicture(picture, part);
      const maxSide = number('maxSide', 0, 0, 16_384);
      const scale = maxSide / Math.max(picture.width, picture.height);
      if (maxSide >= 1 && scale < 1) {
        const sideOf = (side: number): number => Math.max(1, Math.round(side * scale));
        picture = vision.scalePicture(picture, sideOf(picture.width), sideOf(picture.height));
      }
      if (format !== undefined) picture = vision.convertPicture(picture, format);
    } catch (thrown) {
      // Errors that the sender of the image or of a parameter can correct.
      if (!(thrown instanceof RangeError)) throw thrown;
      error = thrown.message;
      picture = undefined;
    }
    error = [...(error ? [error] : []), ...faults].join(' ');
    const isNewError = error !== state.error;
    state.error = error;
    const newError = isNewError ? { string: error } : undefined;
    if (picture === undefined) return newError && { outputs: { error: newError } };

    const { before } = state;
    state.before = picture;
    const isSameSize = before?.width === picture.width && before.height === picture.height;
    const motion = isSameSize ? vision.motionEnergy(before, picture, motionThreshold) : undefined;
    const { width, height, data } = picture;
    const [counts = []] = vision.histogram(vision.greyPicture(picture), bins);
    return {
      outputs: {
        image: {
          timestamp,
          image2D: {
            width,
            height,
            dataFormat: formats.indexOf(picture.format) as 0 | 1 | 2,
            data: new Uint8Array(data),
          },
        },
        motion: motion && { timestamp, double: motion.energy },
        changed: motion && { timestamp, double: motion.changedShare },
        histogram: {
          timestamp,
          doubleList: { elements: Array.from(counts, (count) => count / (width * height)) },
        },
        decodeMs: { double: decodedMs - startedMs },
        durationMs: { double: performance.now() - startedMs },
        error: newError,
      },
    };
  },
});
