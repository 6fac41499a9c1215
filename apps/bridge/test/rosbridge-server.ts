import type { AddressInfo } from 'node:net';
import { encode } from 'cborg';
import { WebSocketServer } from 'ws';
import type { WebSocket } from 'ws';

interface Subscription {
  readonly socket: WebSocket;
  readonly id: string;
  readonly topic: string;
  readonly compression: string;
  readonly throttleMs: number;
}

interface Operation {
  readonly op: string;
  readonly id?: string;
  readonly topic?: string;
  readonly type?: string;
  readonly msg?: Readonly<Record<string, unknown>>;
  readonly compression?: string;
  readonly throttle_rate?: number;
}

/**
 * A rosbridge without ROS, as its protocol describes it (rosbridge_suite, ROSBRIDGE_PROTOCOL.md, version 2): topics, their types,
 * compression `none` and `cbor`. That it is one is checked by `roslib`, which the tests use beside the bridge.
 */
export async function startRosbridge(port = 0) {
  const server = new WebSocketServer({ host: '127.0.0.1', port });
  await new Promise<void>((resolve) => server.once('listening', resolve));
  const subscriptions = new Set<Subscription>();
  const types = new Map<string, string>();
  const operations: Operation[] = [];
  /** `Authorization` of each connection that has one. */
  const logins: string[] = [];
  /** Look again whether what they wait for has happened. */
  const watchers = new Set<() => void>();
  const tellWatchers = (): void => {
    for (const watch of [...watchers]) watch();
  };

  const handle = (socket: WebSocket, operation: Operation): void => {
    const { op, id = '', topic = '', type = '' } = operation;
    operations.push(operation);
    switch (op) {
      case 'advertise': {
        const known = types.get(topic);
        if (known !== undefined && known !== type) {
          const msg = `Tried to advertise topic ${topic} with type ${type} but it is already established with type ${known}`;
          return socket.send(JSON.stringify({ op: 'status', level: 'error', msg }));
        }
        return void types.set(topic, type);
      }
      case 'subscribe':
        if (type !== '') types.set(topic, type);
        return void subscriptions.add({
          socket,
          id,
          topic,
          compression: operation.compression ?? 'none',
          throttleMs: operation.throttle_rate ?? 0,
        });
      case 'unsubscribe':
        for (const one of subscriptions) {
          if (one.socket === socket && one.topic === topic && (id === '' || id === one.id)) {
            subscriptions.delete(one);
          }
        }
        return;
      case 'publish':
        // All subscribers get it, also the sender.
        for (const one of subscriptions) {
          if (one.topic !== topic) continue;
          const message = { op: 'publish', topic, msg: operation.msg };
          one.socket.send(one.compression === 'cbor' ? encode(message) : JSON.stringify(message));
        }
        return;
      case 'unadvertise':
      case 'set_level':
        return;
      default:
        socket.send(
          JSON.stringify({ op: 'status', level: 'error', msg: `Unknown operation: ${op}` }),
        );
    }
  };
  server.on('connection', (socket, { headers }) => {
    if (headers.authorization !== undefined) logins.push(headers.authorization);
    socket.on('error', () => undefined);
    socket.on('message', (data) => {
      handle(socket, JSON.parse(String(data)) as Operation);
      tellWatchers();
    });
    socket.on('close', () => {
      for (const one of subscriptions) if (one.socket === socket) subscriptions.delete(one);
      tellWatchers();
    });
  });
  const { port: bound } = server.address() as AddressInfo;
  return {
    port: bound,
    url: `ws://127.0.0.1:${bound}`,
    operations,
    logins,
    /** Resolves when a client has subscribed to the topic, or only one client is left. */
    untilSubscribed: (topic: string): Promise<void> =>
      new Promise((resolve) => {
        const watch = (): void => {
          if (server.clients.size > 1 && ![...subscriptions].some((one) => one.topic === topic))
            return;
          watchers.delete(watch);
          resolve();
        };
        watchers.add(watch);
        watch();
      }),
    sendAll(frame: string | Uint8Array) {
      for (const socket of server.clients) socket.send(frame);
    },
    async close() {
      for (const socket of server.clients) socket.terminate();
      await new Promise((resolve) => server.close(resolve));
    },
  };
}
