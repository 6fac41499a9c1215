import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Turns a number into events: it rose to a threshold, it fell below it. */
export const threshold = defineProcessingModule({
  name: 'threshold',
  description:
    'Tells when a number rises to a threshold and when it falls below it, with hysteresis.',
  tags: ['event', 'number', 'edge'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    value: 'double',
    threshold: { format: 'double', default: 0.5 },
    hysteresis: { format: 'double', default: 0 },
  },
  outputs: { isAbove: 'bool', rose: 'bool', fell: 'bool', riseCount: 'int32' },
  mode: { triggerOnInput: {} },
  createState: (): { isAbove: boolean | undefined; riseCount: number } => ({
    isAbove: undefined,
    riseCount: 0,
  }),
  onProcessing(_deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // What is no finite number counts as not there.
      number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
      },
    };
    const value = read.value(inputs.value);
    // Infinite is above or below all the same; only what is no number at all is left out.
    if (value === undefined || Number.isNaN(value)) return undefined;
    const upper = read.number(inputs.threshold, 0.5, -Number.MAX_VALUE, Number.MAX_VALUE);
    const lower = upper - read.number(inputs.hysteresis, 0, 0, Number.MAX_VALUE);

    const before = state.isAbove;
    const isAbove = before === true ? value >= lower : value >= upper;
    if (isAbove === before) return undefined;
    state.isAbove = isAbove;
    // The first value says where it is; nothing rose or fell yet.
    if (before === undefined) return { outputs: { isAbove: { bool: isAbove } } };
    if (!isAbove) return { outputs: { isAbove: { bool: false }, fell: { bool: true } } };
    state.riseCount = (state.riseCount + 1) % 2 ** 31;
    return {
      outputs: {
        isAbove: { bool: true },
        rose: { bool: true },
        riseCount: { int32: state.riseCount },
      },
    };
  },
});
