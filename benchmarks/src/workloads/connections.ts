import { readFileSync } from 'node:fs';
import { setTimeout as sleep } from 'node:timers/promises';

import { brokerSubjects, startRawWs, startUbii } from '../brokers/brokers.ts';
import { REFERENCE, type Access, type Broker, type BrokerClient } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { createRecordRing } from '../load/record-ring.ts';
import { startLap } from '../measuring/stopwatch.ts';
import {
  describeFaults,
  type Measurement,
  type MeasureOptions,
  type Workload,
} from '../measuring/workload.ts';

/** Memory of a process that is in RAM, bytes (proc(5), VmRSS). */
function residentBytes(pid: number): number {
  const status = readFileSync(`/proc/${pid}/status`, 'latin1');
  return Number(/^VmRSS:\s+(\d+) kB$/m.exec(status)![1]) * 1024;
}

const UBII = 'ubii-extension';
/**
 * Connections before memory is read, so that compiled code, buffers of the broker and the nursery of its heap are not
 * counted. The nursery grows by 16 MB while so many connect, and stays as it is however many follow.
 */
const FIRST_CONNECTIONS = 1000;
const IDLE_CONNECTIONS = 1000;
/** Clients that join or leave together. */
const AT_ONCE = 10;
/** Clients that come and leave before it is measured: the code of all that they ask for is compiled by then. */
const WARM_UP_CLIENTS = 1500;
/** Until what belongs to joining is over. */
const SETTLE_MS = 2000;
/** Nothing is published: the ring only says what would be expected. */
const ring = createRecordRing('connections', 100, 1);

/** Clients that come, subscribe to a topic and leave, ten at a time. */
export const connecting: Workload = {
  name: 'connecting',
  group: 'connections',
  title: 'Connecting and subscribing, and leaving again',
  figures: [
    {
      key: 'cpuMs',
      label: 'broker CPU a client',
      unit: 'ms',
      isHigherBetter: false,
      goals: { [UBII]: 1.4 },
    },
    { key: 'clientsPerS', label: 'clients', unit: '1/s', isHigherBetter: true, goals: {} },
  ],
  placement: 'core-each',
  reference: REFERENCE,
  roundShare: 1 / 3,
  open: (setting) =>
    brokerSubjects(setting, (target, options) => measureConnecting(target, options)),
};

/** One measurement. */
export async function measureConnecting(
  target: Access,
  { measureMs }: Pick<MeasureOptions, 'measureMs'>,
  warmUpClients = WARM_UP_CLIENTS,
): Promise<Measurement> {
  const verifiers: DeliveryVerifier[] = [];
  const joinAndLeave = async (ms: number, least: number): Promise<number> => {
    const endMs = performance.now() + ms;
    let clients = 0;
    while (performance.now() < endMs || clients < least) {
      const joined = await joinMany(target, AT_ONCE, verifiers);
      await Promise.all(joined.map((client) => client.leave()));
      clients += joined.length;
    }
    return clients;
  };
  await joinAndLeave(0, warmUpClients);
  const stopLap = startLap(target.pids);
  const clients = await joinAndLeave(measureMs, 0);
  const lap = stopLap();
  return {
    figures: {
      cpuMs: lap.cpuUs / 1000 / clients,
      clientsPerS: clients / (lap.wallUs / 1e6),
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: clients,
    faults: describeFaults(verifiers.map((verifier) => verifier.faults)),
  };
}

/** Subscribed clients to whom nothing is sent. Each measurement has a broker of its own, whose memory is fresh. */
export const idleConnections: Workload = {
  name: 'idle-connections',
  group: 'connections',
  title: `${IDLE_CONNECTIONS} subscribed connections without records`,
  figures: [
    {
      key: 'kilobytes',
      label: 'memory a connection',
      unit: 'kB',
      isHigherBetter: false,
      goals: {},
      bounds: { [UBII]: 20 },
    },
    {
      key: 'cpuPercent',
      label: 'broker CPU',
      unit: '% of a core',
      isHigherBetter: false,
      goals: {},
      bounds: { [UBII]: 0.5 },
    },
  ],
  placement: 'anywhere',
  reference: REFERENCE,
  roundShare: 1 / 3,
  open: ({ master, profileDir }) => {
    const subject = (name: string, start: () => Promise<Broker>) => ({
      name,
      pids: [],
      measure: (options: MeasureOptions) => measureIdle(start, options),
    });
    return Promise.resolve([
      subject(REFERENCE, () => startRawWs(profileDir)),
      subject(UBII, () => startUbii(master, profileDir)),
    ]);
  },
};

async function measureIdle(
  start: () => Promise<Broker>,
  { measureMs }: MeasureOptions,
): Promise<Measurement> {
  const broker = await start();
  try {
    const target = broker.targets[0]!;
    const verifiers: DeliveryVerifier[] = [];
    const first = await joinMany(target, FIRST_CONNECTIONS, verifiers);
    await sleep(SETTLE_MS);
    const bytesBefore = residentBytes(target.pid);
    const clients = await joinMany(target, IDLE_CONNECTIONS, verifiers);
    await sleep(SETTLE_MS);
    const bytes = residentBytes(target.pid) - bytesBefore;
    await leaveAll(first);
    await sleep(SETTLE_MS);
    const stopLap = startLap([target.pid]);
    await sleep(2 * measureMs);
    const lap = stopLap();
    await Promise.all(clients.map(({ connection }) => connection.close()));
    return {
      figures: {
        kilobytes: bytes / 1000 / IDLE_CONNECTIONS,
        cpuPercent: (100 * lap.cpuUs) / lap.wallUs,
      },
      otherCpuShare: lap.otherCpuShare,
      deliveries: IDLE_CONNECTIONS,
      faults: describeFaults(verifiers.map((verifier) => verifier.faults)),
    };
  } finally {
    await broker.stop();
  }
}

async function leaveAll(clients: readonly BrokerClient[]): Promise<void> {
  for (let i = 0; i < clients.length; i += AT_ONCE) {
    await Promise.all(clients.slice(i, i + AT_ONCE).map((client) => client.leave()));
  }
}

async function joinMany(
  target: Access,
  count: number,
  verifiers: DeliveryVerifier[],
): Promise<BrokerClient[]> {
  const clients: BrokerClient[] = [];
  while (clients.length < count) {
    const next = Math.min(AT_ONCE, count - clients.length);
    const joined = Array.from({ length: next }, () => {
      const verifier = new DeliveryVerifier(ring, target.wire);
      verifiers.push(verifier);
      return target.join({ publishes: false, topics: [ring.topic] }, verifier);
    });
    clients.push(...(await Promise.all(joined)));
  }
  return clients;
}
