import { fileURLToPath } from 'node:url';

import { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';

import { LoadConnection, type StreamReceiver } from '../load/load-connection.ts';
import type {
  Measurement,
  MeasureOptions,
  Subject,
  WorkloadSetting,
} from '../measuring/workload.ts';
import { startBrokerProcess } from './broker-process.ts';
import type { Broker, BrokerClient, ClientRole, Target } from './target.ts';

const ONE_ROOM = { publish: 'all', subscribe: 'all' };

/** Starts the minimal `ws` server, see raw-ws-broker.mjs. */
export async function startRawWs(profileDir: string | undefined): Promise<Broker> {
  const broker = await startBrokerProcess({
    name: 'raw-ws',
    args: [fileURLToPath(new URL('./raw-ws-broker.mjs', import.meta.url))],
    profileDir,
  });
  const url = String(broker.endpoints['url']);
  return {
    targets: [
      {
        name: 'raw-ws',
        pid: broker.pid,
        pids: [broker.pid],
        join: async ({ publishes, topics, patterns = [], rooms = ONE_ROOM }, receiver) => {
          const query = [
            publishes && `publish=${rooms.publish}`,
            (topics.length > 0 || patterns.length > 0) && `subscribe=${rooms.subscribe}`,
          ];
          const address = `${url}?${query.filter(Boolean).join('&')}`;
          const connection = await LoadConnection.open(address, receiver);
          return { connection, leave: () => connection.close() };
        },
      },
    ],
    stop: () => broker.stop(),
  };
}

/** Starts the built master; its two targets differ in what the clients understand (EX-1, EX-2). */
export async function startUbii(master: string, profileDir: string | undefined): Promise<Broker> {
  const process = await MasterProcess.start({ program: master, profileDir });
  const target = (name: 'ubii-extension' | 'ubii-legacy'): Target => ({
    name,
    pid: process.pid,
    pids: [process.pid],
    join: (role, receiver) => joinMaster(process, role, receiver, name === 'ubii-extension'),
  });
  return {
    targets: [target('ubii-extension'), target('ubii-legacy')],
    stop: () => process.dispose(),
  };
}

/**
 * Registers a client, connects it and subscribes it to its topics.
 *
 * @param topicDataUrl where it connects, when not at the master itself
 */
export async function joinMaster(
  master: MasterProcess,
  { topics, patterns = [] }: ClientRole,
  receiver: StreamReceiver,
  takesLists: boolean,
  topicDataUrl = master.endpoints.topicDataWs,
): Promise<BrokerClient> {
  const extension = takesLists ? { recordLists: true } : undefined;
  const { client } = await master.call({
    topic: SERVICES.clientRegistration.topic,
    client: {
      name: `benchmark ${takesLists ? 'extension' : 'legacy'}`,
      ...(extension && { extension }),
    },
  });
  if (client === undefined) throw new Error('The master registered no client.');
  const token = client.extension?.resumeToken;
  const identity = `${token ? `token=${encodeURIComponent(token)}&` : ''}clientID=${client.id}`;
  const connection = await LoadConnection.open(`${topicDataUrl}?${identity}`, receiver);
  if (topics.length + patterns.length > 0) {
    await master.call({
      topic: SERVICES.topicSubscription.topic,
      topicSubscription: {
        clientId: client.id,
        subscribeTopics: [...topics],
        subscribeTopicRegexp: [...patterns],
      },
    });
  }
  const leave = async (): Promise<void> => {
    await connection.close();
    await master.call({
      topic: SERVICES.clientDeregistration.topic,
      client: { id: client.id },
    });
  };
  return { connection, leave };
}

/** Every broker with every kind of client, as subjects of one workload. */
export async function brokerSubjects(
  { parts, master, profileDir }: WorkloadSetting,
  measure: (target: Target, options: MeasureOptions) => Promise<Measurement>,
): Promise<Subject[]> {
  const rawWs = await parts.get('raw-ws', () => startRawWs(profileDir));
  const ubii = await parts.get('ubii', () => startUbii(master, profileDir));
  return [...rawWs.targets, ...ubii.targets].map((target) => ({
    name: target.name,
    pids: target.pids,
    measure: (options) => measure(target, options),
  }));
}
