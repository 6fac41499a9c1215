import { expect, it } from 'vitest';

import { findTurns, type CpuProfile } from './turns.ts';

const frame = (functionName: string, url = 'file:///master/main.js') => ({
  functionName,
  url,
  lineNumber: 0,
  columnNumber: 0,
});
const NODES = [
  { id: 1, callFrame: frame('(root)', ''), children: [2, 3, 4, 6] },
  { id: 2, callFrame: frame('(idle)', '') },
  { id: 3, callFrame: frame('(garbage collector)', '') },
  { id: 4, callFrame: frame('processTimers', 'node:internal/timers'), children: [5] },
  { id: 5, callFrame: frame('sweep') },
  { id: 6, callFrame: frame('onStreamRead', 'node:internal/streams') },
];

/** A profile with a sample each millisecond. */
function profileOf(...samples: number[]): CpuProfile {
  return { startTime: 0, nodes: NODES, samples, timeDeltas: samples.map(() => 1000) };
}

it('joins samples of one entry, names what took the time, and begins with the longest', () => {
  const profile = profileOf(2, 6, 2, 5, 5, 4, 2, 3, 2);
  expect(findTurns(profile, 0, Infinity)).toEqual([
    { ms: 3, names: ['sweep (main.js)'] },
    { ms: 1, names: ['onStreamRead (streams)'] },
    { ms: 1, names: ['(garbage collector)'] },
  ]);
});

it('parts what comes from different entries, and leaves out what is not in the span', () => {
  const profile = profileOf(5, 5, 6, 6, 6, 2);
  expect(findTurns(profile, 2500, 5500).map(({ ms }) => ms)).toEqual([3]);
  expect(findTurns(profile, 0, Infinity).map(({ ms }) => ms)).toEqual([3, 2]);
});
