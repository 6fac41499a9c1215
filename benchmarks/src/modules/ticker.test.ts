import { runInThisContext } from 'node:vm';

import type { TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';

import { TICKER_HERTZ, TICKER_MODULE, TickerWatch } from './ticker.ts';

const INTERVAL_MS = 1000 / TICKER_HERTZ;

type Ticker = (
  deltaTimeMs: number,
  inputs: object,
  state: object,
) => { outputs: { out: { vector3: { x: number; y: number; z: number } } } };
const run = runInThisContext(`(${TICKER_MODULE.onProcessingStringified})`) as Ticker;

/** The module's outputs for runs that begin at these times. */
function outputsAt(topic: string, startsMs: readonly number[]): TopicRecord[] {
  const state = {};
  return startsMs.map((startMs, index) => {
    const deltaTimeMs = startMs - (startsMs[index - 1] ?? startMs);
    const { out } = run(deltaTimeMs, {}, state).outputs;
    return { topic, format: 'vector3', value: out.vector3, timestampMs: undefined, clientId: '' };
  });
}

describe('TickerWatch', () => {
  it('tells how far from their places runs began, and how many were left out', () => {
    const watch = new TickerWatch(['/a']);
    watch.start();
    const slots = [0, 1, 2, 5, 6];
    // All others come 5 ms early for the rhythm of the first, which was late.
    const startsMs = slots.map(
      (slot) => slot * INTERVAL_MS - (slot === 0 ? 0 : slot === 5 ? 2 : 5),
    );
    for (const record of outputsAt('/a', startsMs)) watch.handleRecord(record, 0);
    const { runs, leftOut, startP99Ms } = watch.stop();
    expect({ runs, leftOut }).toEqual({ runs: 5, leftOut: 2 });
    expect(startP99Ms).toBeCloseTo(5);
    expect(watch.faults).toEqual([]);
  });

  it('tells how late outputs came, going by the earliest', () => {
    const watch = new TickerWatch(['/a']);
    watch.start();
    const records = outputsAt('/a', [0, INTERVAL_MS, 2 * INTERVAL_MS]);
    [100, 100.5, 107].forEach((delayMs, index) =>
      watch.handleRecord(records[index]!, index * INTERVAL_MS + delayMs),
    );
    expect(watch.stop().arrivalP99Ms).toBeCloseTo(7);
  });

  it('finds what is lost, wrong or nobody asked for', () => {
    const watch = new TickerWatch(['/a']);
    const [first, , third] = outputsAt('/a', [0, INTERVAL_MS, 2 * INTERVAL_MS]);
    watch.handleRecord(first!, 0);
    watch.handleRecord(third!, 0);
    watch.handleRecord({ ...first!, topic: '/b' }, 0);
    const wrong = { x: 3, y: 3 * INTERVAL_MS, z: 0 };
    watch.handleRecord({ ...first!, format: 'vector3', value: wrong }, 0);
    expect(watch.faults).toEqual([
      'unexpected: run 2 of /a where 1 was to come',
      'unexpected: a record on /b',
      'unexpected: a wrong sum of run 3 of /a',
    ]);
  });
});
