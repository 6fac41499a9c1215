import { fileURLToPath } from 'node:url';
import { startMosquitto } from '@ubii/harness';
import { greetMqtt, MQTT } from '../load/mqtt-wire.ts';
import { openSocketIo, SOCKET_IO } from '../load/socket-io-wire.ts';
import { StreamConnection } from '../load/stream-connection.ts';
import { startBrokerProcess, type BrokerProcess } from './broker-process.ts';
import { startNatsPart } from './cluster.ts';
import type { Access } from './target.ts';

/** A broker that people would use instead. */
export interface Peer extends Access {
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
    ...{ pids: [pid], wire: SOCKET_IO, stop },
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
  const script = fileURLToPath(new URL(`./${name}-broker.mjs`, import.meta.url));
  const broker = await startBrokerProcess({ name, args: [script], profileDir });
  return {
    pid: broker.pid,
    port: Number(broker.endpoints['port']),
    stop: () => broker.stop(),
  };
}
