import { setTimeout as sleep } from 'node:timers/promises';
import { createClient } from '@ubii/client-web/node';
import type { UbiiClient } from '@ubii/client-web/node';
import { MasterProcess } from '@ubii/harness';
import { percentile } from '../statistics.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions, Subject, Workload } from '../measuring/workload.ts';

/** Interval at which estimated and true time are compared, milliseconds. */
const SAMPLE_MS = 20;
/** A comparison that took longer than this was interrupted, milliseconds. */
const MAX_READING_MS = 0.05;
/** Share of the samples that the stated error has to hold. [TS-4] */
const WITHIN = 0.99;

const STATED = 'stated error';
const TRUE = 'true error';

/**
 * Error of `client.masterTime` against the master's clock, beside the error bound that it states. Both programs run on
 * this machine, so the true time is known: its clock.
 */
export const masterTime: Workload = {
  name: 'master-time',
  group: 'master-time',
  title: 'Master time of a client on loopback',
  figures: [
    { key: 'p50Us', label: 'p50', unit: 'µs', isHigherBetter: false, goals: { [TRUE]: 1 } },
    { key: 'p95Us', label: 'p95', unit: 'µs', isHigherBetter: false, goals: { [TRUE]: 1 } },
  ],
  reference: STATED,
  placement: 'anywhere',
  roundShare: 1,
  open: async ({ parts, master, profileDir }) => {
    const running = await parts.get('master', () =>
      MasterProcess.start({ program: master, profileDir }),
    );
    return [subjectOf(STATED, running), subjectOf(TRUE, running)];
  },
};

function subjectOf(name: string, master: MasterProcess): Subject {
  return {
    name,
    pids: [master.pid],
    measure: (options) => measure(name, master, options),
  };
}

async function measure(
  name: string,
  master: MasterProcess,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const client = createClient({ url: master.url, name: 'timekeeper' });
  await client.connect();
  await sleep(warmUpMs);
  const stopLap = startLap([master.pid]);
  const trueUs: number[] = [];
  const statedUs: number[] = [];
  const endMs = performance.now() + measureMs;
  let outside = 0;
  while (performance.now() < endMs) {
    const sample = compare(client);
    if (sample !== undefined) {
      trueUs.push(sample.trueUs);
      statedUs.push(sample.statedUs);
      if (sample.trueUs > sample.statedUs) outside += 1;
    }
    await sleep(SAMPLE_MS);
  }
  const lap = stopLap();
  await client.close();
  const sorted = (name === TRUE ? trueUs : statedUs).sort((a, b) => a - b);
  const within = 1 - outside / trueUs.length;
  return {
    figures: { p50Us: percentile(sorted, 0.5), p95Us: percentile(sorted, 0.95) },
    otherCpuShare: lap.otherCpuShare,
    deliveries: trueUs.length,
    faults:
      within >= WITHIN
        ? []
        : [`the stated error held the true one in ${(within * 100).toFixed(1)} % of the samples`],
  };
}

/** The system's clock is known to the microsecond where it ticks. */
function compare(client: UbiiClient): { trueUs: number; statedUs: number } | undefined {
  const startMs = Date.now();
  let tickMs = startMs;
  let beforeMs = performance.now();
  while (tickMs === startMs) {
    beforeMs = performance.now();
    tickMs = Date.now();
  }
  const masterMs = client.masterTime.nowMs();
  const tookMs = performance.now() - beforeMs;
  const { estimate } = client.masterTime;
  // Interrupted on the way, it does not know when the tick was.
  if (estimate === undefined || tookMs > MAX_READING_MS || tickMs !== startMs + 1) return undefined;
  return {
    trueUs: Math.abs(masterMs - tickMs - tookMs / 2) * 1000,
    statedUs: estimate.errorMs * 1000,
  };
}
