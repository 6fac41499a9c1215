import { fileURLToPath } from 'node:url';
import { LoadConnection } from '../load/load-connection.ts';
import { startBrokerProcess } from './broker-process.ts';
import type { Broker } from './target.ts';

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
        join: async ({ publishes, topics }, receiver) => {
          const query = [publishes && 'publish=1', topics.length > 0 && 'subscribe=1'];
          const address = `${url}?${query.filter(Boolean).join('&')}`;
          const connection = await LoadConnection.open(address, receiver);
          return { connection, leave: () => connection.close() };
        },
      },
    ],
    stop: () => broker.stop(),
  };
}
