import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { pause } from '../../pause.ts';
import { FaultRun, type Scenario } from '../fault-run.ts';

const HOUR_MS = 3_600_000;
/** Invitations last for seven days here: none of these ends one. */
const JUMPS_MS = [HOUR_MS, -2 * HOUR_MS, 26 * HOUR_MS, -25 * HOUR_MS, 400, -400, 0];

export const clockJumps: Scenario = {
  name: 'clock-jumps',
  about: 'jumps of the wall clock of the master, by hours and days, forth and back',
  async run({ program, random, times }) {
    const folder = mkdtempSync(join(tmpdir(), 'ubii-clock-'));
    const file = join(folder, 'offset');
    const preload = new URL('../shift-clock.mjs', import.meta.url);
    preload.search = encodeURIComponent(file);
    const faultRun = await FaultRun.open(
      { program, nodeFlags: ['--import', preload.href] },
      random,
    );
    const losses: string[] = [];
    const backMs: number[] = [];
    const notes: string[] = [];
    try {
      const heartbeat = await faultRun.heartbeat();
      await faultRun.workFor(500);
      for (let index = 0; index < times; index++) {
        const offsetMs = JUMPS_MS[index % JUMPS_MS.length]!;
        writeFileSync(file, String(offsetMs));
        process.kill(faultRun.master.pid, 'SIGUSR2');
        const begunMs = performance.now();
        await pause(50);
        await heartbeat.beat();
        if (!(await faultRun.workload.save())) {
          losses.push(`nothing can be stored after a jump: ${faultRun.workload.lastRefusal}`);
        }
        backMs.push(performance.now() - begunMs);
        await faultRun.workFor(400);
        losses.push(...(await faultRun.findLosses()));
      }
      const { failures } = faultRun.master;
      if (failures.length > 0) notes.push(`the master logged: ${failures[0]}`);
      return faultRun.outcome(losses, backMs, notes);
    } finally {
      await faultRun.close();
      rmSync(folder, { recursive: true, force: true });
    }
  },
};
