import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { createInterface } from 'node:readline';
import { fileURLToPath } from 'node:url';

import { LossyLink } from '../lossy/lossy-link.ts';
import type { NamespaceMessage } from '../lossy/namespace-run.ts';
import type { Outcome, Scenario } from '../fault-run.ts';

const PROGRAM = fileURLToPath(new URL('../lossy/namespace-run.ts', import.meta.url));
const SEEDS = 2 ** 32;

export const lossyNetwork: Scenario = {
  name: 'lossy-network',
  about:
    'clients behind a link that loses 1 to 100 % of the packets and delivers others late and out of order',
  reasonAgainst: () => LossyLink.reasonAgainst(),
  async run({ program, random, times }) {
    const link = await LossyLink.open();
    const [command, ...words] = [...link.within, process.execPath, ...process.execArgv];
    const child = spawn(
      command!,
      [...words, PROGRAM, program, String(random.below(SEEDS)), String(times)],
      { stdio: ['pipe', 'pipe', 'inherit'] },
    );
    const ended = once(child, 'exit');
    try {
      let outcome: Outcome | undefined;
      for await (const text of createInterface({ input: child.stdout })) {
        const line = JSON.parse(text) as NamespaceMessage;
        if ('outcome' in line) outcome = line.outcome;
        else {
          link.set(line.link);
          child.stdin.write('\n');
        }
      }
      const [code] = await ended;
      if (outcome === undefined)
        throw new Error(`The program in the namespace ended with ${code}.`);
      const { passed, lost } = await link.close();
      return { ...outcome, notes: [...outcome.notes, `${passed} packets passed, ${lost} lost`] };
    } catch (error) {
      child.kill('SIGKILL');
      await ended;
      await link.close();
      throw error;
    }
  },
};
