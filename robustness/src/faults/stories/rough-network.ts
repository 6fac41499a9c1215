import { pause } from '../../pause.ts';
import { RoughRelay } from '../rough-relay.ts';
import type { Story } from '../story.ts';
import { Theatre } from '../theatre.ts';

const SILENCES_MS = [1_000, 4_000, 12_000];

export const roughNetwork: Story = {
  name: 'rough-network',
  about: 'clients behind a way that is late by up to 300 ms, goes silent, and breaks',
  async run({ program, random, times }) {
    const theatre = await Theatre.open({ program }, random);
    const relay = await RoughRelay.open(theatre.master.port, random);
    const losses: string[] = [];
    const backMs: number[] = [];
    try {
      const pulse = await theatre.pulse(relay.url);
      for (let index = 0; index < times; index++) {
        await theatre.workFor(500);
        if (index % 2 === 0) {
          relay.isSilent = true;
          await pause(SILENCES_MS[(index / 2) % SILENCES_MS.length]!);
          relay.isSilent = false;
        } else relay.breakAll();
        backMs.push(await pulse.beat());
        losses.push(...(await theatre.findLosses()));
      }
      return theatre.outcome(losses, backMs);
    } finally {
      relay.close();
      await theatre.close();
    }
  },
};
