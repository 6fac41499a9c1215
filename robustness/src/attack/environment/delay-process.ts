// A caller of this machine in a process of its own: how long questions for the health and records of others take.
import { Witness } from '../../fixtures/witness.ts';
import { pause } from '../../pause.ts';

const PERIOD_MS = 20;
const url = process.argv[2]!;
const witness = await Witness.open(url);

/** Delays of an action that is repeated for so long, milliseconds, the shortest first. */
async function delaysOf(act: () => Promise<unknown>, durationMs: number): Promise<number[]> {
  const endMs = performance.now() + durationMs;
  const delays: number[] = [];
  while (performance.now() < endMs) {
    const begunMs = performance.now();
    await act();
    delays.push(performance.now() - begunMs);
    await pause(PERIOD_MS);
  }
  return delays.sort((a, b) => a - b);
}

process.on('message', (durationMs: number) => {
  void Promise.all([
    delaysOf(async () => (await fetch(`${url}/health`)).arrayBuffer(), durationMs),
    delaysOf(() => witness.check(), durationMs),
  ]).then(([health, record]) => process.send?.({ health, record }));
});
process.on('disconnect', () => process.exit(0));
process.send?.('ready');
