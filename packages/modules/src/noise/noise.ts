import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/**
 * Generates pseudo-random numbers: uniform, normal, and a random walk. The same seed gives the same
 * numbers, so that tests and demonstrations can be repeated.
 *
 * Source of the generator: mulberry32 by T. Ettinger, public domain (2017). Normal numbers: G. E. P. Box,
 * M. E. Muller: "A Note on the Generation of Random Normal Deviates", 1958.
 */
export const noise = defineProcessingModule({
  name: 'noise',
  description: 'Generates uniform, normal and random-walk noise.',
  tags: ['source', 'generator', 'number', 'random'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    amplitude: { format: 'double', default: 1, description: 'Factor of all outputs.' },
    offset: { format: 'double', default: 0, description: 'Added to all outputs.' },
    walkSpeed: {
      format: 'double',
      default: 1,
      description: 'Standard deviation of walk, 0 to 100, after one second.',
    },
    seed: {
      format: 'int32',
      default: 1,
      description: 'Seed of the sequence; a change restarts it.',
    },
  },
  outputs: {
    uniform: { format: 'double', description: 'Uniform numbers, offset ± amplitude.' },
    normal: {
      format: 'double',
      description: 'Normal numbers around the offset; the standard deviation is the amplitude.',
    },
    walk: { format: 'double', description: 'Random walk within offset ± amplitude.' },
  },
  mode: { frequency: { hertz: 30 } },
  createState: (): { seed: number | undefined; random: number; walk: number } => ({
    seed: undefined,
    random: 0,
    walk: 0,
  }),
  onProcessing(deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
      },
      /** From 0 to below 1. */
      random() {
        state.random = (state.random + 0x6d2b79f5) | 0;
        let mixed = Math.imul(state.random ^ (state.random >>> 15), 1 | state.random);
        mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
        return ((mixed ^ (mixed >>> 14)) >>> 0) / 4_294_967_296;
      },
    };
    const amplitude = read.number(inputs.amplitude, 1, -1e150, 1e150);
    const offset = read.number(inputs.offset, 0, -1e150, 1e150);
    const walkSpeed = read.number(inputs.walkSpeed, 1, 0, 100);
    const seed = read.number(inputs.seed, 1, -(2 ** 31), 2 ** 31 - 1) | 0;
    if (state.seed !== seed) {
      state.seed = seed;
      state.random = seed;
      state.walk = 0;
    }

    const uniform = 2 * read.random() - 1;
    // 1 − random is never 0, so the logarithm is finite.
    const radius = Math.sqrt(-2 * Math.log(1 - read.random()));
    const normal = radius * Math.cos(2 * Math.PI * read.random());
    // The variance of a random walk grows with time. After a pause, count one second at most.
    const seconds = Math.min(1, deltaTimeMs / 1000);
    let walk = state.walk + normal * walkSpeed * Math.sqrt(seconds);
    // Reflect at −1 and 1: a triangle wave of period 4.
    walk = ((((walk + 1) % 4) + 4) % 4) - 1;
    if (walk > 1) walk = 2 - walk;
    state.walk = walk;

    return {
      outputs: {
        uniform: { double: offset + amplitude * uniform },
        normal: { double: offset + amplitude * normal },
        walk: { double: offset + amplitude * walk },
      },
    };
  },
});
