import { createInterface } from 'node:readline';

import { pause } from '../../pause.ts';
import { Random } from '../../random.ts';
import { median } from '../../soak/measure.ts';
import { FaultRun, type Outcome } from '../fault-run.ts';
import { FAR, GOOD_LINK, type LinkQuality } from './lossy-link.ts';

/*
 * The part of the scenario `lossy-network` that runs within the namespace of the link. It writes a line of JSON for each
 * quality the link shall have, waits for the answer, and writes its outcome at the end.
 */

/** A fair, a bad and a very bad Wi-Fi, and none. */
const QUALITIES: readonly LinkQuality[] = [
  { loss: 0.01, delayMs: 5, jitterMs: 40 },
  { loss: 0.1, delayMs: 40, jitterMs: 120 },
  { loss: 0.25, delayMs: 100, jitterMs: 200 },
  { loss: 1, delayMs: 0, jitterMs: 0 },
];
/** For so long the link is bad. */
const BAD_MS = 4_000;
/** Numbers whose way is timed while the link is bad. */
const TIMED = 5;

export type NamespaceMessage = { readonly link: LinkQuality } | { readonly outcome: Outcome };

const [program, seed, times] = process.argv.slice(2);
const answers = createInterface({ input: process.stdin })[Symbol.asyncIterator]();
const faultRun = await FaultRun.open(
  { program: program!, network: ['--host', '0.0.0.0', '--allow-legacy', `${FAR}/32`] },
  new Random(Number(seed)),
);
try {
  const url = new URL(faultRun.master.endpoints.url);
  const heartbeat = await faultRun.heartbeat(`http://${FAR}:${url.port}`);
  const losses: string[] = [];
  const backMs: number[] = [];
  const late = new Map<LinkQuality, number[]>();
  for (let index = 0; index < Number(times); index++) {
    const quality = QUALITIES[index % QUALITIES.length]!;
    await setLink(quality);
    await Promise.all([faultRun.workFor(BAD_MS), pause(BAD_MS)]);
    if (quality.loss < 1) {
      const found = late.get(quality) ?? [];
      late.set(quality, found);
      for (let beats = 0; beats < TIMED; beats++) found.push(await heartbeat.beat());
    }
    await setLink(GOOD_LINK);
    backMs.push(await heartbeat.beat());
    losses.push(...(await faultRun.findLosses()));
  }
  const notes = [...late].map(([{ loss, delayMs, jitterMs }, ms]) => {
    const link = `${loss * 100} % lost, ${delayMs} to ${delayMs + jitterMs} ms late`;
    return `${link}: a number needs ${Math.round(median(ms))} ms (median), ${Math.round(Math.max(...ms))} ms (most)`;
  });
  send({ outcome: faultRun.outcome(losses, backMs, notes) });
} finally {
  await faultRun.close();
}
process.exit(0);

async function setLink(link: LinkQuality): Promise<void> {
  send({ link });
  await answers.next();
}

function send(line: NamespaceMessage): void {
  process.stdout.write(`${JSON.stringify(line)}\n`);
}
