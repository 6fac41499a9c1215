import * as tf from '@tensorflow/tfjs-core';

/**
 * A small network of the layers that detectors consist of (convolution, depthwise and pointwise
 * convolution) with integer weights. Plain arithmetic gives its exact results, which reveals faulty
 * backends; its duration compares backends.
 *
 * 128 × 128 pixels give 113 million multiplications, a tenth of what detectors need (40 ms with wasm), so
 * that the overhead of a call does not dominate the time of a graphics card.
 */
export const PROBE = { size: 128, inputs: 16, middles: 32, outputs: 64 } as const;

/** Half the width of a 3 × 3 kernel. */
const REACH = 1;
const KERNEL = 3;

/** Whole numbers of a fixed pattern; `range` values around `least`. */
function pattern(length: number, factor: number, range: number, least: number): Float32Array {
  return Float32Array.from({ length }, (_, index) => ((index * factor) % range) + least);
}

// Primes as factors and ranges, so that no two kernels are equal. The largest sum stays below 2^24,
// up to where 32-bit floats are exact: 144 · 6 · 1 (first), · 9 (second), · 32 (third) = 248 832.
const image = (): Float32Array => pattern(PROBE.size ** 2 * PROBE.inputs, 31, 7, 0);
const first = (): Float32Array => pattern(KERNEL ** 2 * PROBE.inputs * PROBE.middles, 37, 3, -1);
const second = (): Float32Array => pattern(KERNEL ** 2 * PROBE.middles, 41, 3, -1);
const third = (): Float32Array => pattern(PROBE.middles * PROBE.outputs, 43, 3, -1);

/**
 * Runs the network on the backend that is set now.
 *
 * @returns size × size × outputs numbers, row by row
 */
export async function runProbe(): Promise<Float32Array> {
  const { size, inputs, middles, outputs } = PROBE;
  const result = tf.tidy(() => {
    const x = tf.tensor4d(image(), [1, size, size, inputs]);
    const y = tf.relu(
      tf.conv2d(x, tf.tensor4d(first(), [KERNEL, KERNEL, inputs, middles]), 1, 'same'),
    );
    const z = tf.depthwiseConv2d(
      y as tf.Tensor4D,
      tf.tensor4d(second(), [KERNEL, KERNEL, middles, 1]),
      1,
      'same',
    );
    return tf.conv2d(z, tf.tensor4d(third(), [1, 1, middles, outputs]), 1, 'same');
  });
  try {
    return (await result.data()) as Float32Array;
  } finally {
    result.dispose();
  }
}

/** Numbers of the network at some places. */
export interface KnownResult {
  /** Index in what `runProbe` returns. */
  readonly index: number;
  readonly value: number;
}

/** Rows and columns that are compared: both edges and some between. 12 places, all outputs of each. */
const ROWS = [0, 77, PROBE.size - 1];
const COLUMNS = [0, 1, 62, PROBE.size - 1];
const PLACES = ROWS.flatMap((y) => COLUMNS.map((x) => ({ x, y })));

/** Computes in plain arithmetic what the network must give at some places. */
export function knownResults(): KnownResult[] {
  const { size, inputs, middles, outputs } = PROBE;
  const [x, w1, w2, w3] = [image(), first(), second(), third()];
  const isInside = (at: number): boolean => at >= 0 && at < size;

  const afterFirst = (row: number, column: number, middle: number): number => {
    let sum = 0;
    for (let dy = -REACH; dy <= REACH; dy++) {
      for (let dx = -REACH; dx <= REACH; dx++) {
        if (!isInside(row + dy) || !isInside(column + dx)) continue;
        const pixel = ((row + dy) * size + column + dx) * inputs;
        const weight = ((dy + REACH) * KERNEL + dx + REACH) * inputs;
        for (let input = 0; input < inputs; input++) {
          sum += x[pixel + input]! * w1[(weight + input) * middles + middle]!;
        }
      }
    }
    return Math.max(0, sum);
  };
  const afterSecond = (row: number, column: number, middle: number): number => {
    let sum = 0;
    for (let dy = -REACH; dy <= REACH; dy++) {
      for (let dx = -REACH; dx <= REACH; dx++) {
        if (!isInside(row + dy) || !isInside(column + dx)) continue;
        const weight = w2[((dy + REACH) * KERNEL + dx + REACH) * middles + middle]!;
        sum += weight * afterFirst(row + dy, column + dx, middle);
      }
    }
    return sum;
  };
  return PLACES.flatMap((place) => {
    const before = Array.from({ length: middles }, (_, m) => afterSecond(place.y, place.x, m));
    return Array.from({ length: outputs }, (_, output) => ({
      index: (place.y * size + place.x) * outputs + output,
      value: before.reduce((sum, value, m) => sum + value * w3[m * outputs + output]!, 0),
    }));
  });
}

/**
 * Returns how far computed numbers are from the known ones, as a share of the largest known number.
 * Infinity when one of them is no number.
 */
export function probeError(computed: Float32Array, known: readonly KnownResult[]): number {
  const largest = known.reduce((most, { value }) => Math.max(most, Math.abs(value)), 0);
  return known.reduce((most, { index, value }) => {
    const error = Math.abs((computed[index] ?? NaN) - value) / largest;
    return Number.isNaN(error) ? Infinity : Math.max(most, error);
  }, 0);
}
