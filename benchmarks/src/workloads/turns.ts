import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { startRawWs } from '../brokers/raw-ws.ts';
import { REFERENCE, type Access, type Broker, type BrokerClient } from '../brokers/target.ts';
import { startUbii } from '../brokers/ubii.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { createRecordRing } from '../load/record-ring.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions, Workload } from '../measuring/workload.ts';
import { PartyTraffic } from '../party/party-traffic.ts';
import { findTurns, type CpuProfile, type Turn } from '../turns/longest-turns.ts';

const OURS = 'ubii-extension';
/** Turns that are listed. */
const LISTED = 20;
/** Turns that hold other work up. */
const LONG_MS = 0.5;
/** A measurement is this many times as long as others: what is rare has to happen. */
const TIMES = 15;
/** Clients that stay beside the party, and those that come and leave each second. */
const IDLE_CLIENTS = 200;
const COMING_CLIENTS = 5;
const ring = createRecordRing('turns', 100, 1);

/** What holds the thread of a broker, from a CPU profile with a sample each 0.2 ms. */
export const turns: Workload = {
  name: 'turns',
  group: 'turns',
  title: 'Longest turns while a party plays, 200 clients are idle, and 5 a second come and leave',
  figures: [
    { key: 'longestMs', label: 'longest', unit: 'ms', isHigherBetter: false, goals: {} },
    { key: 'longPerS', label: 'over 0.5 ms', unit: '1/s', isHigherBetter: false, goals: {} },
    { key: 'heldPercent', label: 'time in those', unit: '%', isHigherBetter: false, goals: {} },
  ],
  placement: 'core-each',
  reference: REFERENCE,
  roundShare: 1 / 5,
  open: ({ master }) => {
    const subject = (
      name: string,
      start: (profileDir: string) => Promise<Broker>,
      file: string,
    ) => ({
      name,
      pids: [],
      measure: (options: MeasureOptions) => measureTurns(start, file, options),
    });
    return Promise.resolve([
      subject(REFERENCE, startRawWs, 'raw-ws'),
      subject(OURS, (profileDir) => startUbii(master, profileDir), 'ubii'),
    ]);
  },
};

async function measureTurns(
  start: (profileDir: string) => Promise<Broker>,
  file: string,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const folder = mkdtempSync(join(tmpdir(), 'ubii-turns-'));
  try {
    const broker = await start(folder);
    let span: readonly [number, number];
    let faults: string[];
    let records: number;
    let otherCpuShare: number;
    try {
      const access = broker.targets[0]!;
      const idle = await joinMany(access, IDLE_CLIENTS);
      const traffic = await PartyTraffic.open(access);
      traffic.play();
      await sleep(2000 + warmUpMs);
      const stopLap = startLap(access.pids);
      const fromUs = monotonicUs();
      const endMs = performance.now() + TIMES * measureMs;
      while (performance.now() < endMs) {
        const coming = await joinMany(access, COMING_CLIENTS);
        await sleep(1000);
        await Promise.all(coming.map((client) => client.leave()));
      }
      span = [fromUs, monotonicUs()];
      ({ otherCpuShare } = stopLap());
      ({ faults, records } = await traffic.end());
      await Promise.all(idle.map(({ connection }) => connection.close()));
    } finally {
      await broker.stop();
    }
    const text = readFileSync(join(folder, `${file}.cpuprofile`), 'utf8');
    const found = findTurns(JSON.parse(text) as CpuProfile, ...span);
    const long = found.filter(({ ms }) => ms > LONG_MS);
    const seconds = (span[1] - span[0]) / 1e6;
    return {
      figures: {
        longestMs: found[0]?.ms ?? 0,
        longPerS: long.length / seconds,
        heldPercent: long.reduce((sum, { ms }) => sum + ms, 0) / seconds / 10,
      },
      ...{ otherCpuShare, deliveries: records, faults },
      notes: found.slice(0, LISTED).map(describe),
    };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

function describe({ ms, names }: Turn): string {
  return `${ms.toFixed(2)} ms  ${names.join(' > ')}`;
}

/** The clock of CPU profiles. */
function monotonicUs(): number {
  return Number(process.hrtime.bigint() / 1000n);
}

function joinMany(access: Access, count: number): Promise<BrokerClient[]> {
  const role = {
    publishes: false,
    topics: [ring.topic],
    rooms: { publish: '', subscribe: 'idle' },
  };
  return Promise.all(
    Array.from({ length: count }, () => access.join(role, new DeliveryVerifier(ring))),
  );
}
