import { MASTER_FOR_TESTS } from '@ubii/harness';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';

import { MonitoredMaster, caseOf } from './fuzz-entrance.ts';
import { readCorpus } from './corpus.ts';
import type { FuzzTarget } from './entrance.ts';
import { ENTRANCES } from './entrances/index.ts';
import { fromBase64 } from './seeds.ts';

/** Fixed: the gate is no lottery. `npm run fuzz` takes others. */
const SEED = 20_261_122;
const CASES = { running: 18, start: 2, parser: 150 } as const;

describe(`mutated inputs, seed ${SEED}`, () => {
  let monitored: MonitoredMaster;

  beforeAll(async () => {
    monitored = await MonitoredMaster.open(MASTER_FOR_TESTS);
  });
  afterAll(() => monitored?.close());

  it.each(ENTRANCES.map((entrance) => [entrance.name, entrance] as const))(
    '%s',
    async (_, entrance) => {
      const seeds = entrance.seeds();
      const cases = entrance.gateCases ?? CASES[entrance.kind];
      for (let index = 0; index < cases; index++) {
        const input = caseOf(entrance, seeds, SEED, index);
        const deliver =
          entrance.kind === 'running'
            ? monitored.deliver(entrance, input)
            : entrance.deliver(input, { program: MASTER_FOR_TESTS } as FuzzTarget);
        await deliver.catch((error: unknown) => {
          const text = Buffer.from(input).toString('base64');
          throw new Error(`Case ${index} (${text}): ${String(error)}`);
        });
      }
      await monitored.check();
    },
  );

  const finds = readCorpus();
  const mended = finds.filter(({ todo }) => todo === undefined);
  it.each(mended.map((find) => [find.file, find] as const))(
    '%s does no harm any more',
    async (_, { entrance: name, inputs }) => {
      const entrance = ENTRANCES.find((one) => one.name === name)!;
      for (const input of fromBase64(inputs)) {
        if (entrance.kind === 'running') await monitored.deliver(entrance, input);
        else await entrance.deliver(input, { program: MASTER_FOR_TESTS } as FuzzTarget);
      }
      await monitored.check();
    },
  );
  for (const { file, todo } of finds) if (todo !== undefined) it.todo(`${file}: ${todo}`);

  it('gives the same inputs for the same seed', () => {
    const entrance = ENTRANCES[0]!;
    const seeds = entrance.seeds();
    expect(caseOf(entrance, seeds, 1, 5)).toEqual(caseOf(entrance, entrance.seeds(), 1, 5));
    expect(caseOf(entrance, seeds, 1, 5)).not.toEqual(caseOf(entrance, seeds, 2, 5));
  });
});
