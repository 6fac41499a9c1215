import { fileURLToPath } from 'node:url';
import { LoadConnection } from '../load/load-connection.ts';
import { startBrokerProcess } from './broker-process.ts';
import type { Broker } from './target.ts';

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
