import { randomInt } from 'node:crypto';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { BUILT_MASTER } from '@ubii/harness';

import { keepFind, readCorpus } from './corpus.ts';
import { ENTRANCES } from './entrances/index.ts';
import { fuzzEntrance, replay, type FuzzResult } from './fuzz-entrance.ts';
import { recordSeeds } from './record-seeds.ts';
import { fromBase64 } from './seeds.ts';

const HELP = `Sends mutated inputs to every entrance of a built master, and looks whether a witness notices.

  npm run fuzz                      every entrance, ten minutes in all
  npm run fuzz -- --replay          what was found before, once more

  --minutes <n>     time of the whole run (default 10)
  --seed <n>        the same seed gives the same inputs (default: random; it is printed)
  --entrance <x>,…  ${ENTRANCES.map(({ name }) => name).join(', ')}
  --master <file>   another build of the master
  --record          write the seeds again, from programs of the client library
  --help            this text

Finds go to robustness/corpus, where the gate replays them. Ends with 1 when there are any.`;

const { values } = parseArgs({
  options: {
    minutes: { type: 'string', default: '10' },
    seed: { type: 'string' },
    entrance: { type: 'string' },
    master: { type: 'string' },
    record: { type: 'boolean' },
    replay: { type: 'boolean' },
    help: { type: 'boolean', short: 'h' },
  },
});
const program =
  values.master === undefined
    ? BUILT_MASTER
    : resolve(process.env['INIT_CWD'] ?? process.cwd(), values.master);

if (values.help) console.log(HELP);
else if (values.record) console.log(await recordSeeds(program));
else if (values.replay) await replayCorpus();
else await fuzzAll();

async function replayCorpus(): Promise<void> {
  for (const { file, entrance: name, inputs, todo } of readCorpus()) {
    const entrance = ENTRANCES.find((one) => one.name === name)!;
    const problem = await replay(entrance, program, fromBase64(inputs));
    console.log(`${file}: ${problem ?? 'fine'}${todo === undefined ? '' : ` (to do: ${todo})`}`);
    if (problem !== undefined && todo === undefined) process.exitCode = 1;
  }
}

async function fuzzAll(): Promise<void> {
  const wanted = values.entrance?.split(',') ?? ENTRANCES.map(({ name }) => name);
  const entrances = ENTRANCES.filter(({ name }) => wanted.includes(name));
  if (entrances.length !== wanted.length) {
    console.error(`--entrance needs names of ${ENTRANCES.map(({ name }) => name).join(', ')}.`);
    process.exitCode = 2;
    return;
  }
  const seed = values.seed === undefined ? randomInt(2 ** 32) : Number(values.seed);
  const shareMs = (Number(values.minutes) * 60_000) / entrances.length;
  console.log(
    `seed ${seed}, ${Math.round(shareMs / 1000)} s for each of ${entrances.length} entrances`,
  );
  const results: FuzzResult[] = [];
  for (const entrance of entrances) {
    const endMs = performance.now() + shareMs;
    const result = await fuzzEntrance(entrance, {
      program,
      seed,
      maxCases: Number.POSITIVE_INFINITY,
      goesOn: () => performance.now() < endMs,
      onFind: (find) => console.log(`FOUND ${keepFind(find)}: ${find.reason.slice(0, 2_000)}`),
    });
    results.push(result);
    const { cases, finds, longestMs } = result;
    console.log(
      `${entrance.name.padEnd(12)} ${String(cases).padStart(9)} inputs  ${finds} finds  witness at most ${Math.round(longestMs)} ms`,
    );
  }
  const finds = results.reduce((sum, result) => sum + result.finds, 0);
  const cases = results.reduce((sum, result) => sum + result.cases, 0);
  console.log(`${cases} inputs, ${finds} finds, seed ${seed}`);
  if (finds > 0) process.exitCode = 1;
}
