import type { Scenario } from '../scenario.ts';
import { FaultRun } from '../fault-run.ts';

const WITHIN_MS = 2_000;

export const killMaster: Scenario = {
  name: 'kill-master',
  about: 'kill -9 of the master at random moments, and a start on the same data',
  async run({ program, random, times }) {
    const faultRun = await FaultRun.open({ program }, random);
    const losses: string[] = [];
    const backMs: number[] = [];
    try {
      const heartbeat = await faultRun.heartbeat();
      for (let index = 0; index < times; index++) {
        await faultRun.killDuringWork(random, WITHIN_MS);
        const begunMs = performance.now();
        await faultRun.master.restart();
        await heartbeat.beat();
        backMs.push(performance.now() - begunMs);
        losses.push(...(await faultRun.findLosses()));
      }
      return faultRun.outcome(losses, backMs);
    } finally {
      await faultRun.close();
    }
  },
};
