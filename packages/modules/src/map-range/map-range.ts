import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Maps a number from one range to another: scales, offsets, clamps, inverts, and applies a curve. */
export const mapRange = defineProcessingModule({
  name: 'map-range',
  description: 'Maps a number from one range to another.',
  tags: ['number', 'scale', 'clamp'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    value: { format: 'double', description: 'Number to map.' },
    inMin: { format: 'double', default: 0, description: 'The value that is mapped to outMin.' },
    inMax: {
      format: 'double',
      default: 1,
      description: 'The value that is mapped to outMax; may be less than inMin.',
    },
    outMin: { format: 'double', default: 0, description: 'Start of the output range.' },
    outMax: {
      format: 'double',
      default: 1,
      description: 'End of the output range; may be less than outMin.',
    },
    clamp: {
      format: 'bool',
      default: true,
      description: 'True limits the result to the output range.',
    },
    invert: {
      format: 'bool',
      default: false,
      description: 'True swaps the ends of the output range.',
    },
    exponent: {
      format: 'double',
      default: 1,
      description: 'Curve, 0.01 to 100: 1 is linear, 2 starts slowly, 0.5 starts fast.',
    },
  },
  outputs: {
    mapped: { format: 'double', description: 'The mapped number.' },
  },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs) {
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
    const value = read.value(inputs.value);
    if (value === undefined || Number.isNaN(value)) return undefined;
    const inMin = read.number(inputs.inMin, 0, -1e150, 1e150);
    const inMax = read.number(inputs.inMax, 1, -1e150, 1e150);
    const outMin = read.number(inputs.outMin, 0, -1e150, 1e150);
    const outMax = read.number(inputs.outMax, 1, -1e150, 1e150);
    const exponent = read.number(inputs.exponent, 1, 0.01, 100);

    // An empty range is a step: 0 below it, otherwise 1.
    let share = inMin === inMax ? (value < inMin ? 0 : 1) : (value - inMin) / (inMax - inMin);
    if (inputs.clamp?.bool ?? true) share = Math.min(1, Math.max(0, share));
    // Beyond the range, mirror the curve, so that it stays monotonic.
    if (exponent !== 1) share = Math.sign(share) * Math.abs(share) ** exponent;
    if (inputs.invert?.bool) share = 1 - share;
    // Interpolate from the closer end, so that both ends are exact and rounding cannot exceed them.
    const range = outMax - outMin;
    const mapped = share < 0.5 ? outMin + range * share : outMax - range * (1 - share);
    return Number.isFinite(mapped) ? { outputs: { mapped: { double: mapped } } } : undefined;
  },
});
