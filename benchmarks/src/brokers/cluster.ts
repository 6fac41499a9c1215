import { fileURLToPath } from 'node:url';

import { MasterProcess, startNats, type NatsServer } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';

import { LoadConnection } from '../load/load-connection.ts';
import { greetNats, NATS } from '../load/nats-wire.ts';
import { StreamConnection } from '../load/stream-connection.ts';
import { startBrokerProcess, type BrokerProcess } from './broker-process.ts';
import { joinMaster } from './brokers.ts';
import type { Access } from './target.ts';

/** Masters in the cluster. */
const MASTERS = 3;
const HEARD_MS = 20_000;
const METRIC = 'ubii_cluster_masters';

/** Several masters and their NATS server. */
export interface RunningCluster {
  readonly nats: NatsPart;
  readonly masters: readonly MasterProcess[];
  /** All processes, NATS included. */
  readonly pids: readonly number[];
  stop(): Promise<void>;
}

/** A NATS server with clients of its own. */
export interface NatsPart extends Access {
  readonly url: string;
  stop(): Promise<void>;
}

/** Starts NATS with the stores that a cluster needs. */
export async function startNatsPart(): Promise<NatsPart> {
  const server: NatsServer = await startNats({ jetstream: true });
  const killWithUs = (): void => killProcess(server.pid);
  process.once('exit', killWithUs);
  return {
    url: server.url,
    pids: [server.pid!],
    wire: NATS,
    async join({ topics }, receiver) {
      const connection = await StreamConnection.open(greetNats(server.port, topics[0]), receiver);
      return { connection, leave: () => connection.close() };
    },
    stop: async () => {
      process.off('exit', killWithUs);
      await server.stop();
    },
  };
}

function killProcess(pid: number | undefined): void {
  if (pid !== undefined) process.kill(pid, 'SIGKILL');
}

/** Starts masters that work as one, and resolves when they hear each other. */
export async function startCluster(
  master: string,
  profileDir: string | undefined,
): Promise<RunningCluster> {
  const nats = await startNatsPart();
  const masters: MasterProcess[] = [];
  const stop = async (): Promise<void> => {
    await Promise.all(masters.map((each) => each.dispose()));
    await nats.stop();
  };
  try {
    for (let index = 0; index < MASTERS; index += 1) {
      const flags = ['--cluster', nats.url];
      const name = `master-${index + 1}`;
      masters.push(
        await MasterProcess.start({ program: master, profileDir, flags, profileName: name }),
      );
    }
    await Promise.all(masters.map(waitForOthers));
  } catch (error) {
    await stop();
    throw error;
  }
  return { nats, masters, pids: [...nats.pids, ...masters.map(({ pid }) => pid)], stop };
}

/** Clients of one of the masters, which take record lists. @param pids see `Access` */
export function accessTo(
  { masters }: RunningCluster,
  index: number,
  pids: readonly number[],
): Access {
  return {
    pids,
    async join(role, receiver) {
      const client = await joinMaster(masters[index]!, role, receiver, true);
      if (role.topics.length > 0) await Promise.all(masters.map(passOthers));
      return client;
    },
  };
}

/** Clients of all masters: each joins the next one. */
export function accessToAll(cluster: RunningCluster): Access {
  const { masters, pids } = cluster;
  let count = 0;
  return {
    pids,
    join(role, receiver) {
      count += 1;
      return accessTo(cluster, count % masters.length, pids).join(role, receiver);
    },
  };
}

/** Waits until a master has the messages of all others so far: they answer this call after their earlier messages. [CU-29] */
async function passOthers(master: MasterProcess): Promise<void> {
  await master.call({ topic: SERVICES.topicList.topic });
}

async function waitForOthers(master: MasterProcess): Promise<void> {
  const endMs = performance.now() + HEARD_MS;
  while (performance.now() < endMs) {
    if ((await master.metrics()).get(METRIC) === MASTERS - 1) return;
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error('The masters of the cluster did not hear each other.');
}

const RELAY = fileURLToPath(new URL('./relay-broker.mjs', import.meta.url));
const SUBJECTS = ['relay-1', 'relay-2'] as const;

/** Two relays between WebSocket clients and NATS, each with clients of its own. */
export interface Relays {
  /** One for each relay. CPU time is counted for NATS and both. */
  readonly accesses: readonly Access[];
  stop(): Promise<void>;
}

/** Starts two relays, see relay-broker.mjs. @param nats the server that is between them */
export async function startRelays(
  nats: { readonly url: string; readonly pids: readonly number[] },
  profileDir: string | undefined,
): Promise<Relays> {
  const relays: BrokerProcess[] = [];
  const stop = async (): Promise<void> => {
    await Promise.all(relays.map((relay) => relay.stop()));
  };
  try {
    for (const own of SUBJECTS) {
      const other = SUBJECTS.find((subject) => subject !== own)!;
      relays.push(
        await startBrokerProcess({
          name: own,
          args: [RELAY, nats.url.replace(/^\w+:\/\//, ''), own, other],
          profileDir,
        }),
      );
    }
  } catch (error) {
    await stop();
    throw error;
  }
  const pids = [...nats.pids, ...relays.map(({ pid }) => pid)];
  return { accesses: relays.map((relay) => accessToRelay(relay, pids)), stop };
}

function accessToRelay({ endpoints }: BrokerProcess, pids: readonly number[]): Access {
  return {
    pids,
    join: async (_, receiver) => {
      const connection = await LoadConnection.open(String(endpoints['url']), receiver);
      return { connection, leave: () => connection.close() };
    },
  };
}
