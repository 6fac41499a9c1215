import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Converts a number to events: it has risen to a threshold, or fallen below it. */
export const threshold = defineProcessingModule({
  name: 'threshold',
  description: 'Reports when a number crosses a threshold.',
  tags: ['event', 'number', 'edge'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    value: { format: 'double', description: 'Number to compare.' },
    threshold: {
      format: 'double',
      default: 0.5,
      description: 'The number counts as above from this value on.',
    },
    hysteresis: {
      format: 'double',
      default: 0,
      description: 'Distance below the threshold at which the number counts as below, 0 or more.',
    },
  },
  outputs: {
    isAbove: { format: 'bool', description: 'True while the number is above the threshold.' },
    rose: { format: 'bool', description: 'True when the number rises to the threshold.' },
    fell: {
      format: 'bool',
      description: 'True when the number falls below the threshold minus hysteresis.',
    },
    riseCount: { format: 'int32', description: 'Number of rises since the start.' },
  },
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
      // A number that is not finite counts as missing.
      number(record: NumberRecord | undefined, fallback: number, min: number, max: number) {
        const value = this.value(record);
        return Number.isFinite(value) ? Math.min(max, Math.max(min, value!)) : fallback;
      },
    };
    const value = read.value(inputs.value);
    // An infinite number is above or below the threshold; only NaN is ignored.
    if (value === undefined || Number.isNaN(value)) return undefined;
    const upper = read.number(inputs.threshold, 0.5, -Number.MAX_VALUE, Number.MAX_VALUE);
    const lower = upper - read.number(inputs.hysteresis, 0, 0, Number.MAX_VALUE);

    const before = state.isAbove;
    const isAbove = before === true ? value >= lower : value >= upper;
    if (isAbove === before) return undefined;
    state.isAbove = isAbove;
    // The first value sets the state without an event.
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
