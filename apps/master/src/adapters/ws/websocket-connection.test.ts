import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { decodeTopicData } from '@ubii/proto';
import { scanTopicData } from '@ubii/proto/wire';
import { WebSocket } from 'ws';

import type { ClientConnection } from '../../core/ports/index.ts';
import { clientConnectionSuite } from '../../testing/acceptance/index.ts';
import type { ConnectionPair, Seen } from '../../testing/acceptance/index.ts';
import { StreamLog } from '../log/stream-log.ts';
import { OriginPolicy } from '../network/origin-policy.ts';
import { TopicDataSockets } from './topic-data-sockets.ts';
import { TRUSTED_CALLER } from '../../index.ts';

clientConnectionSuite('WebSocketConnection', openPair);

/** A real client at the other end of a real socket. */
async function openPair(): Promise<ConnectionPair> {
  let handOver: (connection: ClientConnection) => void = () => {};
  const opened = new Promise<ClientConnection>((resolve) => (handOver = resolve));
  const sockets = new TopicDataSockets({
    master: {
      openConnection(_query, connection) {
        handOver(connection);
        return undefined;
      },
      refuseConnection: () => undefined,
    },
    callers: { read: () => TRUSTED_CALLER },
    policy: new OriginPolicy({ isOnLan: () => false, host: 'localhost', allowedOrigins: [] }),
    log: new StreamLog({ level: 'error', format: 'json', write: () => {}, nowMs: () => 0 }),
    clock: { after: () => () => undefined },
    maxMessageBytes: 1000,
  });
  const server = createServer().on('upgrade', (request, socket, head) =>
    sockets.handleUpgrade(request, socket, head),
  );
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  const inbox = new Inbox(new WebSocket(`ws://127.0.0.1:${port}/?clientID=x`));
  return {
    connection: await opened,
    next: () => inbox.next(),
    async dispose() {
      sockets.terminate();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}

/** Messages that a client receives, stored until they are read. */
class Inbox {
  readonly #seen: Seen[] = [];
  #wake: () => void = () => {};

  constructor(client: WebSocket) {
    const add = (seen: Seen) => {
      this.#seen.push(seen);
      this.#wake();
    };
    client.on('message', (data: Buffer, isBinary) => {
      const text = data.toString();
      add(isBinary ? parseFrame(data) : parseText(text));
    });
    client.on('close', (code, reason) => add({ kind: 'close', code, reason: reason.toString() }));
    client.on('error', () => {});
  }

  async next(): Promise<Seen> {
    for (;;) {
      const seen = this.#seen.shift();
      if (seen !== undefined) return seen;
      await new Promise<void>((resolve) => (this.#wake = resolve));
    }
  }
}

/** Tag of `TopicData.topic_data_record_list`. */
const LIST_TAG = 26;

function parseFrame(frame: Buffer): Seen {
  const { error, nodeMessages } = decodeTopicData(frame);
  if (nodeMessages.length > 0) return { kind: 'frame', frame };
  if (error !== undefined) return { kind: 'error', error };
  const records: Uint8Array[] = [];
  scanTopicData(frame, {
    record: (_topic, start, end) => records.push(frame.subarray(start, end)),
    error: () => {},
  });
  const [record = new Uint8Array()] = records;
  return frame[0] === LIST_TAG ? { kind: 'list', records } : { kind: 'record', record };
}

function parseText(text: string): Seen {
  if (text === 'PING' || text === 'PONG') return { kind: text };
  return { kind: 'PONG', text };
}
