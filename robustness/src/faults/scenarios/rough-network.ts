import { pause } from '../../pause.ts';
import { RoughRelay } from '../rough-relay.ts';
import type { Scenario } from '../scenario.ts';
import { FaultRun } from '../fault-run.ts';

const SILENCES_MS = [1_000, 4_000, 12_000];

export const roughNetwork: Scenario = {
  name: 'rough-network',
  about: 'clients behind a way that is late by up to 300 ms, goes silent, and breaks',
  async run({ program, random, times }) {
    const faultRun = await FaultRun.open({ program }, random);
    const relay = await RoughRelay.open(faultRun.master.port, random);
    const losses: string[] = [];
    const backMs: number[] = [];
    try {
      const heartbeat = await faultRun.heartbeat(relay.url);
      for (let index = 0; index < times; index++) {
        await faultRun.workFor(500);
        if (index % 2 === 0) {
          relay.isSilent = true;
          await pause(SILENCES_MS[(index / 2) % SILENCES_MS.length]!);
          relay.isSilent = false;
        } else relay.breakAll();
        backMs.push(await heartbeat.beat());
        losses.push(...(await faultRun.findLosses()));
      }
      return faultRun.outcome(losses, backMs);
    } finally {
      relay.close();
      await faultRun.close();
    }
  },
};
