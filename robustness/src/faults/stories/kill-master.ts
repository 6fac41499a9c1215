import type { Story } from '../story.ts';
import { Theatre } from '../theatre.ts';

const WITHIN_MS = 2_000;

export const killMaster: Story = {
  name: 'kill-master',
  about: 'kill -9 of the master at random moments, and a start on the same data',
  async run({ program, random, times }) {
    const theatre = await Theatre.open({ program }, random);
    const losses: string[] = [];
    const backMs: number[] = [];
    try {
      const pulse = await theatre.pulse();
      for (let index = 0; index < times; index++) {
        await theatre.killDuringWork(random, WITHIN_MS);
        const begunMs = performance.now();
        await theatre.master.restart();
        await pulse.beat();
        backMs.push(performance.now() - begunMs);
        losses.push(...(await theatre.findLosses()));
      }
      return theatre.outcome(losses, backMs);
    } finally {
      await theatre.close();
    }
  },
};
