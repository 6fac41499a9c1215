import { defineProcessingModule } from '@ubii/pm-sandbox';
import type { NumberRecord } from '../number-record.ts';

/**
 * Does a chosen amount of work in each run, and tells how long it took: Fibonacci numbers, as in the
 * session speed test of the original frontend.
 */
export const loadGenerator = defineProcessingModule({
  name: 'load-generator',
  description: 'Adds up Fibonacci numbers for a chosen number of steps and tells how long it took.',
  tags: ['load', 'benchmark', 'performance'],
  authors: ['Ubi-Interact'],
  version: '1.0.0',
  inputs: { iterations: { format: 'int32', default: 1000 }, stamp: 'double' },
  outputs: { result: 'double', durationMs: 'double', runs: 'int32', echo: 'double' },
  mode: { frequency: { hertz: 30 } },
  createState: () => ({ runs: 0 }),
  onProcessing(_deltaTimeMs, inputs, state) {
    const read = {
      value(record: NumberRecord | undefined) {
        return record?.double ?? record?.float ?? record?.int32;
      },
      // Not every sandbox has a fine clock.
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
      // Modulo 2^32: the work of a step does not depend on how far it got.
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
