import { existsSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { decode, encode, SERVICES, type Init, type ServiceRequest } from '@ubii/proto';
import { LoadConnection } from '../load/load-connection.ts';
import { startBrokerProcess } from './broker-process.ts';
import type { Broker, Target } from './target.ts';

/** The master as `npm run build` leaves it. */
export const BUILT_MASTER = fileURLToPath(
  new URL('../../../apps/master/dist/main.js', import.meta.url),
);

/** Starts the built master; its two targets differ in what the clients understand (EX-1, EX-2). */
export async function startUbii(master: string, profileDir: string | undefined): Promise<Broker> {
  if (!existsSync(master)) {
    throw new Error(`There is no master at ${master}: run \`npm run build\` first.`);
  }
  const dataDir = await mkdtemp(join(tmpdir(), 'ubii-bench-'));
  const flags = ['--host', '127.0.0.1', '--port', '0', '--legacy-ports', 'off'];
  const broker = await startBrokerProcess({
    name: 'ubii',
    args: [master, ...flags, '--data-dir', dataDir, '--print-endpoints', 'json'],
    profileDir,
  });
  const services = String(broker.endpoints['servicesBinary']);
  const topicData = String(broker.endpoints['topicDataWs']);

  const target = (name: 'ubii-extension' | 'ubii-legacy'): Target => ({
    name,
    pid: broker.pid,
    join: async ({ subscribes }, ring) => {
      const extension = name === 'ubii-extension' ? { recordLists: true } : undefined;
      const { client } = await call(services, {
        topic: SERVICES.clientRegistration.topic,
        client: { name: `benchmark ${name}`, ...(extension && { extension }) },
      });
      if (client === undefined) throw new Error('The master registered no client.');
      const token = client.extension?.resumeToken;
      const identity = `${token ? `token=${encodeURIComponent(token)}&` : ''}clientID=${client.id}`;
      const connection = await LoadConnection.open(`${topicData}?${identity}`, ring);
      if (subscribes) {
        await call(services, {
          topic: SERVICES.topicSubscription.topic,
          topicSubscription: { clientId: client.id, subscribeTopics: [ring.topic] },
        });
      }
      const leave = async (): Promise<void> => {
        await connection.close();
        await call(services, {
          topic: SERVICES.clientDeregistration.topic,
          client: { id: client.id },
        });
      };
      return { connection, leave };
    },
  });

  return {
    targets: [target('ubii-extension'), target('ubii-legacy')],
    stop: async () => {
      await broker.stop();
      await rm(dataDir, { recursive: true, force: true });
    },
  };
}

async function call(url: string, request: Init<ServiceRequest>) {
  const response = await fetch(url, {
    method: 'POST',
    headers: { 'content-type': 'application/octet-stream' },
    body: Buffer.from(encode('ubii.services.ServiceRequest', request)),
  });
  const reply = decode('ubii.services.ServiceReply', new Uint8Array(await response.arrayBuffer()));
  if (reply.error !== undefined) {
    throw new Error(`${request.topic} was answered with: ${reply.error.message}`);
  }
  return reply;
}
