import { BUILT_NODE, MASTER_FOR_TESTS } from '@ubii/harness';
import { describe, expect, it } from 'vitest';

import { Random } from '../random.ts';
import { SmallDisk, fullDisk } from './scenarios/full-disk.ts';
import { killMaster } from './scenarios/kill-processes.ts';

/** Fixed: the gate is no lottery. `npm run faults` takes others. */
const SEED = 20_261_122;

describe(`faults, seed ${SEED}`, () => {
  it('kill -9 of the master loses nothing that it acknowledged', async () => {
    const options = {
      program: MASTER_FOR_TESTS,
      node: BUILT_NODE,
      random: new Random(SEED),
      times: 1,
    };
    const { acknowledged, losses, backMs } = await killMaster.run(options);
    expect(losses).toEqual([]);
    expect(acknowledged).toBeGreaterThan(0);
    expect(backMs).toHaveLength(1);
  });

  const reason = SmallDisk.reasonAgainst();
  if (reason !== undefined) console.warn(`The test of the full disk is left out: ${reason}.`);
  it.skipIf(reason !== undefined)('a full disk loses nothing that was acknowledged', async () => {
    const options = {
      program: MASTER_FOR_TESTS,
      node: BUILT_NODE,
      random: new Random(SEED),
      times: 1,
    };
    const { losses, refused } = await fullDisk.run(options);
    expect(losses).toEqual([]);
    expect(refused).toBeGreaterThan(0);
  });
});
