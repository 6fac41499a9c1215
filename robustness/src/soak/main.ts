import { randomInt } from 'node:crypto';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';

import { mib, BUILT_MASTER } from '@ubii/harness';

import { QUANTITIES, type Quantity } from './measure.ts';
import { soak, type SoakResult } from './soak.ts';

/** Quantities that were more at rest at the end than after the warm-up, or in the last quarter than in the first. */
function findGrown({ growth, quiet: [first, last] }: SoakResult): readonly Quantity[] {
  return (Object.keys(QUANTITIES) as Quantity[]).filter((quantity) => {
    const { relative, absolute, isBytes } = QUANTITIES[quantity];
    const more = last[quantity] - first[quantity];
    const tolerated = Math.max(absolute, isBytes ? relative * first[quantity] : 0);
    return growth.get(quantity)!.isGrown || more > tolerated;
  });
}

/** The figures as a table. */
function formatSoak(result: SoakResult): string {
  const { growth, quiet, counters, failures } = result;
  const grown = findGrown(result);
  const rows = (Object.keys(QUANTITIES) as Quantity[]).map((quantity) => {
    const { title, isBytes } = QUANTITIES[quantity];
    const text = (value: number): string => (isBytes ? mib(value) : String(Math.round(value)));
    const { quarters, tolerated, isRising } = growth.get(quantity)!;
    const cells = [...quarters, quiet[0][quantity], quiet[1][quantity], tolerated].map(text);
    const verdict = grown.includes(quantity) ? 'GROWN' : isRising ? 'rises, within' : 'as before';
    return [title, ...cells, verdict];
  });
  const head = ['', ...['1st', '2nd', '3rd', '4th'].map((name) => `${name} quarter`)];
  head.push('rest before', 'rest after', 'tolerated', '');
  const widths = head.map((_, at) => Math.max(...[head, ...rows].map((row) => row[at]!.length)));
  const lines = [head, ...rows].map((row) =>
    row
      .map((cell, at) => (at === 0 ? cell.padEnd(widths[at]!) : cell.padStart(widths[at]!)))
      .join('  ')
      .trimEnd(),
  );
  const counts = [...counters.counts].map(([what, count]) => `${count} ${what}`);
  const problems = [...counters.problems].map(([what, count]) => `  ${count} × ${what}`);
  return [
    ...lines,
    counts.join(', '),
    ...(problems.length > 0 ? ['Went wrong:', ...problems] : ['Nothing went wrong.']),
    ...(failures.length > 0 ? ['The master logged:', ...failures.slice(0, 12)] : []),
  ].join('\n');
}

const HELP = `Keeps a built master busy, and looks whether anything grows.

  npm run soak                       64 clients, sessions, phones and files, for 20 minutes

  --minutes <n>     time of the whole run (default 20)
  --clients <n>     clients that stay (default 64)
  --phones <n>      phones at once that come and go (default 16)
  --sessions <n>    sessions at once that start and end (default 4)
  --uploads <n>     files at once that are uploaded, played and deleted; a third of them hostile (default 2)
  --seed <n>        of what phones do (default: random; it is printed)
  --master <file>   another build of the master
  --help            this text

A quarter of the time is warm-up. Then memory, descriptors, files, timers, topics and the like are compared: the quarters of
the rest of the run by their medians, and the master at rest after the warm-up with the master at rest at the end.
Ends with 1 when something has grown by more than is tolerated, or something went wrong. Needs Linux for all figures.`;

const { values } = parseArgs({
  options: {
    minutes: { type: 'string', default: '20' },
    clients: { type: 'string', default: '64' },
    phones: { type: 'string', default: '16' },
    sessions: { type: 'string', default: '4' },
    uploads: { type: 'string', default: '2' },
    seed: { type: 'string' },
    master: { type: 'string' },
    help: { type: 'boolean', short: 'h' },
  },
});

if (values.help) console.log(HELP);
else {
  const seed = values.seed === undefined ? randomInt(2 ** 32) : Number(values.seed);
  const begunMs = performance.now();
  console.log(`seed ${seed}, ${values.minutes} minutes, ${values.clients} clients`);
  let samples = 0;
  const result = await soak({
    program:
      values.master === undefined
        ? BUILT_MASTER
        : resolve(process.env['INIT_CWD'] ?? process.cwd(), values.master),
    durationMs: Number(values.minutes) * 60_000,
    clients: Number(values.clients),
    phones: Number(values.phones),
    sessions: Number(values.sessions),
    uploads: Number(values.uploads),
    seed,
    onSample({ heapBytes, residentBytes, descriptors, topics, timers }, counters) {
      if (samples++ % 6 !== 0) return;
      const atS = Math.round((performance.now() - begunMs) / 1000);
      const records = counters.counts.get('records') ?? 0;
      console.log(
        `${String(atS).padStart(5)} s  heap ${mib(heapBytes)}  resident ${mib(residentBytes)}  ${descriptors} descriptors  ${topics} topics  ${timers} timers  ${records} records`,
      );
    },
  });
  console.log(formatSoak(result));
  const grown = findGrown(result);
  console.log(grown.length === 0 ? 'Nothing grew.' : `Grew: ${grown.join(', ')}.`);
  if (grown.length > 0 || result.counters.problems.size > 0 || result.failures.length > 0) {
    process.exitCode = 1;
  }
}
