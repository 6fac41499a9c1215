import { describe, expect, it } from 'vitest';

import { MASTER_FOR_TESTS } from '../master/built-master.ts';
import { FAULTS } from './faults/index.ts';
import { LoopbackGround } from './ground/loopback-ground.ts';
import { MASTER_COUNT, runFaults } from './run.ts';

/** Fixed: the gate is no lottery. `npm run cluster-faults` takes others. */
const SEED = 20_261_127;
/** Those that take a few seconds each. */
const SHORT = ['calm', 'kill-master'];

describe(`faults of a cluster, seed ${SEED}`, () => {
  it(`${SHORT.join(', ')} lose, repeat and reorder nothing that the specification does not name`, async () => {
    const lines: string[] = [];
    const reports = await runFaults({
      ground: new LoopbackGround(MASTER_COUNT),
      program: MASTER_FOR_TESTS,
      faults: FAULTS.filter(({ name }) => SHORT.includes(name)),
      seed: SEED,
      ...{ clients: 20, topics: 2, topicsPerClient: 2, periodMs: 200, canOpenMore: false },
      say: (text) => lines.push(text),
    });
    expect(reports.flatMap(({ violations }) => violations)).toEqual([]);
    expect(reports.map(({ name }) => name)).toEqual(SHORT);
  });
});
