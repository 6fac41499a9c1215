import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/**
 * Generates load: computes Fibonacci numbers in each run and measures the time, as the session speed
 * test of the original frontend does.
 */
export const loadGenerator = defineProcessingModule({
  name: 'load-generator',
  description: 'Computes Fibonacci steps and measures the time.',
  tags: ['load', 'benchmark', 'performance'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: {
    iterations: {
      format: 'int32',
      default: 1000,
      description: 'Additions in each run, 0 to 10 000 000.',
    },
    stamp: { format: 'double', description: 'Any number; echo returns it, to measure latency.' },
  },
  outputs: {
    result: {
      format: 'double',
      description: 'Fibonacci number at the index iterations, modulo 2^32.',
    },
    durationMs: { format: 'double', description: 'Time of the additions, ms.' },
    runs: { format: 'int32', description: 'Runs since the start.' },
    echo: { format: 'double', description: 'The number of stamp, with its timestamp.' },
  },
  mode: { frequency: { hertz: 30 } },
  createState: () => ({ runs: 0 }),
  onProcessing(_deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // Some sandboxes have only a coarse clock.
      nowMs() {
        return typeof performance === 'object' ? performance.now() : Date.now();
      },
    };
    const wanted = read.value(inputs.iterations) ?? 1000;
    const iterations = Number.isFinite(wanted) ? Math.min(10_000_000, Math.max(0, wanted)) : 1000;

    const startedMs = read.nowMs();
    let previous = 0;
    let current = 1;
    for (let step = 0; step < iterations; step++) {
      // Modulo 2^32, so that each step takes the same time.
      const next = (previous + current) >>> 0;
      previous = current;
      current = next;
    }
    const durationMs = read.nowMs() - startedMs;

    state.runs = (state.runs + 1) % 2 ** 31;
    const stamp = read.value(inputs.stamp);
    return {
      outputs: {
        result: { double: previous },
        durationMs: { double: Math.max(0, durationMs) },
        runs: { int32: state.runs },
        echo: Number.isFinite(stamp)
          ? { double: stamp!, timestamp: inputs.stamp?.timestamp }
          : undefined,
      },
    };
  },
});
