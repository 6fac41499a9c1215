import { randomInt } from 'node:crypto';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { BUILT_MASTER, BUILT_NODE } from '@ubii/harness';

import { Random } from '../random.ts';
import { median } from '../soak/measure.ts';
import { SCENARIOS } from './scenarios/index.ts';
import type { Outcome, Scenario } from './fault-run.ts';

const HELP = `Injects faults into a built master under a workload, and finds lost changes.

  npm run faults                     every fault, some five minutes in all

  --minutes <n>     time of the whole run (default 5; 60 for an hour)
  --only <name>,…   ${SCENARIOS.map(({ name }) => name).join(', ')}
  --seed <n>        the same seed gives the same workload and moments (default: random; it is printed)
  --master <file>   another build of the master
  --help            this text

A workload stores and starts sessions, makes and revokes invitations; every acknowledged change is expected afterwards.
Ends with 1 when an acknowledged change is lost, or the master does not recover. Full and read-only disks take root on Linux.`;

const { values } = parseArgs({
  options: {
    minutes: { type: 'string', default: '5' },
    only: { type: 'string' },
    seed: { type: 'string' },
    master: { type: 'string' },
    help: { type: 'boolean', short: 'h' },
  },
});

if (values.help) console.log(HELP);
else await runAll();

async function runAll(): Promise<void> {
  const wanted = values.only?.split(',') ?? SCENARIOS.map(({ name }) => name);
  const scenarios = SCENARIOS.filter(({ name }) => wanted.includes(name));
  if (scenarios.length !== wanted.length) {
    console.error(`--only needs names of ${SCENARIOS.map(({ name }) => name).join(', ')}.`);
    process.exitCode = 2;
    return;
  }
  const seed = values.seed === undefined ? randomInt(2 ** 32) : Number(values.seed);
  console.log(`seed ${seed}, ${values.minutes} minutes`);
  const shareMs = (Number(values.minutes) * 60_000) / scenarios.length;
  const program =
    values.master === undefined
      ? BUILT_MASTER
      : resolve(process.env['INIT_CWD'] ?? process.cwd(), values.master);
  let isWell = true;
  for (const scenario of scenarios) {
    const reason = scenario.reasonAgainst?.();
    if (reason !== undefined) {
      console.log(`${scenario.name}: left out, ${reason}`);
      continue;
    }
    const random = new Random(seed);
    const endMs = performance.now() + shareMs;
    const outcomes: Outcome[] = [];
    try {
      // Short runs, one after the other: each begins with an empty data directory.
      do outcomes.push(await scenario.run({ program, node: BUILT_NODE, random, times: 6 }));
      while (performance.now() < endMs);
    } catch (error) {
      isWell = false;
      console.log(`${scenario.name}: ${error instanceof Error ? error.stack : String(error)}`);
    }
    if (outcomes.length === 0) continue;
    if (outcomes.some(({ losses }) => losses.length > 0)) isWell = false;
    console.log(format(scenario, outcomes));
  }
  process.exit(isWell ? 0 : 1);
}

function format({ name, about }: Scenario, outcomes: readonly Outcome[]): string {
  const sum = (read: (one: Outcome) => number): number =>
    outcomes.reduce((all, one) => all + read(one), 0);
  const losses = outcomes.flatMap((one) => one.losses);
  const backMs = outcomes.flatMap((one) => one.backMs);
  const notes = [...new Set(outcomes.flatMap((one) => one.notes))];
  return [
    `${name}: ${about}`,
    `  ${backMs.length} faults, ${sum((one) => one.acknowledged)} acknowledged, ${sum((one) => one.refused)} not; lost of what was acknowledged: ${losses.length}`,
    `  all back after ${Math.round(median(backMs))} ms (median), ${Math.round(Math.max(...backMs))} ms (most)`,
    ...losses.slice(0, 20).map((loss) => `  LOST ${loss}`),
    ...notes.map((note) => `  ${note}`),
  ].join('\n');
}
