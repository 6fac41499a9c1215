import { fileURLToPath } from 'node:url';

import { startMosquitto } from '@ubii/harness';

import { startBrokerProcess, type BrokerProcess } from '../brokers/broker-process.ts';
import { brokerSubjects } from '../brokers/brokers.ts';
import { startNatsPart } from '../brokers/cluster.ts';
import type { Access } from '../brokers/target.ts';
import { greetMqtt, MQTT } from '../load/mqtt-wire.ts';
import { createRecordRing } from '../load/record-ring.ts';
import { openSocketIo, SOCKET_IO } from '../load/socket-io-wire.ts';
import { StreamConnection } from '../load/stream-connection.ts';
import type { Measurement, MeasureOptions, Workload } from '../measuring/workload.ts';
import { connecting, measureConnecting } from './connections.ts';
import {
  FAN_OUT_1,
  FAN_OUT_64,
  FAN_OUT_PICTURES,
  fanOutWorkload,
  measureFanOut,
} from './fan-out.ts';
import { measureRoundTrip, roundTrip } from './round-trip.ts';

/** A broker that people would use instead. */
interface Peer extends Access {
  stop(): Promise<void>;
}

/** Starts each, by name. */
export const PEERS: Readonly<Record<string, (profileDir?: string) => Promise<Peer>>> = {
  nats: startNatsPart,
  mosquitto: startMosquittoPeer,
  aedes: startAedes,
  'socket.io': startSocketIo,
};

async function startMosquittoPeer(): Promise<Peer> {
  const broker = await startMosquitto(() => [
    'allow_anonymous true',
    'set_tcp_nodelay true',
    // Its defaults drop records of quality of service 0 when more wait.
    'max_queued_messages 0',
    'max_queued_bytes 0',
  ]);
  return { pids: [broker.pid!], ...mqttClients('Mosquitto', broker.port), stop: broker.close };
}

async function startAedes(profileDir?: string): Promise<Peer> {
  const { pid, port, stop } = await startScript('aedes', profileDir);
  return { pids: [pid], ...mqttClients('Aedes', port), stop };
}

async function startSocketIo(profileDir?: string): Promise<Peer> {
  const { pid, port, stop } = await startScript('socket-io', profileDir);
  return {
    pids: [pid],
    wire: SOCKET_IO,
    stop,
    async join({ topics }, receiver) {
      const connection = await openSocketIo(`ws://127.0.0.1:${port}`, topics[0], receiver);
      return { connection, leave: () => connection.close() };
    },
  };
}

function mqttClients(broker: string, port: number): Pick<Access, 'wire' | 'join'> {
  return {
    wire: MQTT,
    async join({ topics }, receiver) {
      const greeting = greetMqtt(broker, port, topics[0]);
      const connection = await StreamConnection.open(greeting, receiver);
      return { connection, leave: () => connection.close() };
    },
  };
}

async function startScript(
  name: string,
  profileDir: string | undefined,
): Promise<Pick<BrokerProcess, 'pid' | 'stop'> & { readonly port: number }> {
  const script = fileURLToPath(new URL(`../brokers/${name}-broker.mjs`, import.meta.url));
  const broker = await startBrokerProcess({ name, args: [script], profileDir });
  return {
    pid: broker.pid,
    port: Number(broker.endpoints['port']),
    stop: () => broker.stop(),
  };
}

/** Clients of ours that are not those of today: they are in the workloads without peers. */
const LEGACY = 'ubii-legacy';

type Measure = (access: Access, options: MeasureOptions) => Promise<Measurement>;

/** The same workloads, with the brokers that people would use instead. */
export const PEER_WORKLOADS: readonly Workload[] = [
  withPeers(roundTrip, () => {
    const ring = createRecordRing('round-trip');
    return (access, options) => measureRoundTrip(access, ring, options);
  }),
  ...[FAN_OUT_64, FAN_OUT_1, FAN_OUT_PICTURES].map((fan) =>
    withPeers(fanOutWorkload(fan, {}), () => {
      const ring = fan.createRing();
      return (access, options) => measureFanOut(fan, access, ring, options);
    }),
  ),
  withPeers(connecting, () => measureConnecting),
];

function withPeers(workload: Workload, prepare: () => Measure): Workload {
  return {
    ...workload,
    name: `peers-${workload.name}`,
    group: 'peers',
    figures: workload.figures.map((figure) => ({ ...figure, goals: {} })),
    roundShare: 1 / 3,
    open: async (setting) => {
      const measure = prepare();
      const ours = await brokerSubjects(setting, measure);
      const theirs = Object.entries(PEERS).map(async ([name, start]) => {
        const peer = await setting.parts.get(name, () => start(setting.profileDir));
        return {
          name,
          pids: peer.pids,
          measure: (options: MeasureOptions) => measure(peer, options),
        };
      });
      return [...ours.filter(({ name }) => name !== LEGACY), ...(await Promise.all(theirs))];
    },
  };
}
