import { fileURLToPath } from 'node:url';
import { LoadConnection } from '../load/load-connection.ts';
import { startBrokerProcess, type BrokerProcess } from './broker-process.ts';
import type { Access } from './target.ts';

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
  return { accesses: relays.map((relay) => accessTo(relay, pids)), stop };
}

function accessTo({ endpoints }: BrokerProcess, pids: readonly number[]): Access {
  return {
    pids,
    join: async (_, receiver) => {
      const connection = await LoadConnection.open(String(endpoints['url']), receiver);
      return { connection, leave: () => connection.close() };
    },
  };
}
