import { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { LoadConnection, type StreamReceiver } from '../load/load-connection.ts';
import type { Broker, BrokerClient, ClientRole, Target } from './target.ts';

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
