import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/**
 * Converts an image to greyscale and detects its edges.
 *
 * Sources: luma of ITU-R BT.601; the operator of I. Sobel and G. Feldman, "A 3x3 Isotropic Gradient
 * Operator for Image Processing", 1968.
 */
export const pictureEdges = defineProcessingModule({
  name: 'picture-edges',
  description: 'Converts an image to grey, and detects edges.',
  tags: ['image', 'filter', 'edge'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    picture: {
      format: 'image2D',
      description: 'Raw pixels (GRAY8, RGB8 or RGBA8), up to 640 × 480.',
    },
    threshold: {
      format: 'double',
      default: 0,
      description:
        'Edge strength, 0 to 1, below which pixels are black, others white; 0 keeps the strength.',
    },
  },
  outputs: {
    grey: { format: 'image2D', description: 'Brightness of the image, GRAY8.' },
    edges: { format: 'image2D', description: 'Strength of the edges, GRAY8.' },
    error: {
      format: 'string',
      description: 'Problem with the image; empty when there is none.',
    },
  },
  mode: { triggerOnInput: {} },
  createState: () => ({ error: '' }),
  onProcessing(_deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
      },
    };
    const picture = inputs.picture?.image2D;
    if (picture === undefined) return undefined;
    const { width, height, data } = picture;
    const channels =
      Number(picture.dataFormat) === 1 ? 3 : Number(picture.dataFormat) === 2 ? 4 : 1;
    const size = width * height;
    let error = '';
    if (!(width > 0 && height > 0 && data?.length === size * channels)) {
      error = `The image has ${data?.length ?? 0} bytes instead of ${size * channels}. Send raw pixels: GRAY8, RGB8 or RGBA8.`;
    } else if (size > 640 * 480) {
      error = `The image has ${width} × ${height} pixels. Send at most 640 × 480.`;
    }
    const isNew = error !== state.error;
    state.error = error;
    if (error !== '') return isNew ? { outputs: { error: { string: error } } } : undefined;

    const grey = new Uint8Array(size);
    for (let pixel = 0; pixel < size; pixel++) {
      const at = pixel * channels;
      grey[pixel] =
        channels === 1
          ? data[at]!
          : 0.299 * data[at]! + 0.587 * data[at + 1]! + 0.114 * data[at + 2]! + 0.5;
    }
    const threshold = 255 * read.number(inputs.threshold, 0, 0, 1);
    const edges = new Uint8Array(size);
    // The outermost pixels have no neighbours on one side and stay 0.
    for (let y = 1; y < height - 1; y++) {
      for (let x = 1; x < width - 1; x++) {
        const at = y * width + x;
        const up = at - width;
        const down = at + width;
        const dx =
          grey[up + 1]! -
          grey[up - 1]! +
          2 * (grey[at + 1]! - grey[at - 1]!) +
          grey[down + 1]! -
          grey[down - 1]!;
        const dy =
          grey[down - 1]! -
          grey[up - 1]! +
          2 * (grey[down]! - grey[up]!) +
          grey[down + 1]! -
          grey[up + 1]!;
        const strength = Math.min(255, Math.sqrt(dx * dx + dy * dy));
        edges[at] = threshold === 0 ? strength : strength >= threshold ? 255 : 0;
      }
    }
    // 0 is GRAY8.
    return {
      outputs: {
        grey: { image2D: { width, height, dataFormat: 0, data: grey } },
        edges: { image2D: { width, height, dataFormat: 0, data: edges } },
        error: isNew ? { string: '' } : undefined,
      },
    };
  },
});
