import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/** Aggregate of consecutive numbers. `m2` is the sum of squared deviations from the mean. */
interface Aggregate {
  count: number;
  mean: number;
  m2: number;
  min: number;
  max: number;
}

interface StatisticsState {
  /** Time of the newest run, milliseconds since the first. */
  nowMs: number;
  /** Older samples, newest first, each with the aggregate of itself and all newer samples in this list. */
  older: { atMs: number; aggregate: Aggregate }[];
  /** Newer samples, oldest first, and their aggregate. */
  newer: { atMs: number; value: number }[];
  newerAggregate: Aggregate;
}

/**
 * Computes statistics of the newest values of a number: of a time window, of a number of values, or of
 * the smaller one of both.
 *
 * Values are never subtracted from a sum, so that an outlier has no effect after it has left the window.
 * Two stacks form a queue: the aggregate of the newer samples is updated with each sample, those of the
 * older samples are computed when the samples change stacks. Both are merged by the formula of Chan, Golub
 * and LeVeque ("Updating Formulae and a Pairwise Algorithm for Computing Sample Variances", 1979). The
 * average cost of a run does not depend on the window.
 */
export const statistics = defineProcessingModule({
  name: 'statistics',
  description: 'Computes mean, minimum, maximum and deviation.',
  tags: ['number', 'statistics', 'window'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    value: { format: 'double', description: 'Number to aggregate, up to ±1e140.' },
    windowMs: {
      format: 'double',
      default: 1000,
      description: 'Values older than this do not count, in ms; 0: no limit.',
    },
    windowCount: {
      format: 'int32',
      default: 0,
      description: 'Most values that count, 0 to 10 000; 0: as many as possible.',
    },
  },
  outputs: {
    count: { format: 'int32', description: 'Number of values in the window.' },
    mean: { format: 'double', description: 'Arithmetic mean.' },
    min: { format: 'double', description: 'Smallest value.' },
    max: { format: 'double', description: 'Largest value.' },
    standardDeviation: {
      format: 'double',
      description: 'Standard deviation of the sample; 0 with one value.',
    },
    rms: { format: 'double', description: 'Root of the mean square.' },
  },
  mode: { triggerOnInput: {} },
  createState: (): StatisticsState => ({
    nowMs: 0,
    older: [],
    newer: [],
    newerAggregate: { count: 0, mean: 0, m2: 0, min: Infinity, max: -Infinity },
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
    };
    const aggregate = {
      none(): Aggregate {
        return { count: 0, mean: 0, m2: 0, min: Infinity, max: -Infinity };
      },
      one(value: number): Aggregate {
        return { count: 1, mean: value, m2: 0, min: value, max: value };
      },
      merge(a: Aggregate, b: Aggregate): Aggregate {
        if (a.count === 0) return b;
        if (b.count === 0) return a;
        const count = a.count + b.count;
        const delta = b.mean - a.mean;
        return {
          count,
          mean: a.mean + (delta * b.count) / count,
          m2: a.m2 + b.m2 + (delta * delta * a.count * b.count) / count,
          min: Math.min(a.min, b.min),
          max: Math.max(a.max, b.max),
        };
      },
    };
    const windowMs = read.number(inputs.windowMs, 1000, 0, Number.MAX_VALUE);
    const windowCount = Math.floor(read.number(inputs.windowCount, 0, 0, 10_000)) || 10_000;

    state.nowMs += deltaTimeMs;
    const value = read.value(inputs.value);
    // Squares of larger numbers would be infinite.
    const isUsable = value !== undefined && Math.abs(value) <= 1e140;
    // A run triggered by a parameter has no new sample.
    const triggers = state.inputTriggerNames ?? [];
    const isNew = triggers.length === 0 || triggers.includes('value');
    if (isUsable && isNew) {
      state.newer.push({ atMs: state.nowMs, value });
      state.newerAggregate = aggregate.merge(state.newerAggregate, aggregate.one(value));
    }

    for (;;) {
      if (state.older.length === 0) {
        let merged = aggregate.none();
        for (const { atMs, value: sample } of state.newer.reverse()) {
          merged = aggregate.merge(aggregate.one(sample), merged);
          state.older.push({ atMs, aggregate: merged });
        }
        state.newer = [];
        state.newerAggregate = aggregate.none();
      }
      const oldest = state.older.at(-1);
      if (oldest === undefined) break;
      const isTooOld = windowMs > 0 && state.nowMs - oldest.atMs >= windowMs;
      if (!isTooOld && state.older.length + state.newer.length <= windowCount) break;
      state.older.pop();
    }

    const oldest = state.older.at(-1);
    const all = aggregate.merge(oldest?.aggregate ?? aggregate.none(), state.newerAggregate);
    if (all.count === 0) return { outputs: { count: { int32: 0 } } };
    return {
      outputs: {
        count: { int32: all.count },
        mean: { double: all.mean },
        min: { double: all.min },
        max: { double: all.max },
        standardDeviation: { double: all.count > 1 ? Math.sqrt(all.m2 / (all.count - 1)) : 0 },
        rms: { double: Math.sqrt(all.mean * all.mean + all.m2 / all.count) },
      },
    };
  },
});
