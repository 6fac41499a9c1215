import { randomInt } from 'node:crypto';
import { createServer, connect, type AddressInfo, type Socket } from 'node:net';

/** Ports that no system gives to clients, so that nobody takes one between two servers on it. */
const LASTING = { first: 20_000, end: 32_000 } as const;
const ATTEMPTS = 50;

/** Finds a TCP port of the loopback that nothing listens on. */
export function freePort(): Promise<number> {
  return portOf(0);
}

/**
 * Finds a TCP port of the loopback for servers that listen on it one after the other.
 *
 * @throws Error when 50 ports chosen at random are all taken
 */
export async function lastingPort(): Promise<number> {
  for (let attempt = 0; attempt < ATTEMPTS; attempt++) {
    const port = await portOf(randomInt(LASTING.first, LASTING.end)).catch(() => undefined);
    if (port !== undefined) return port;
  }
  throw new Error(`No port between ${LASTING.first} and ${LASTING.end} was free.`);
}

/** Listens for a moment. @param wanted 0: any port */
async function portOf(wanted: number): Promise<number> {
  const server = createServer();
  await new Promise<void>((resolve, reject) => {
    server.once('error', reject).listen(wanted, '127.0.0.1', resolve);
  });
  const { port } = server.address() as AddressInfo;
  await new Promise((resolve) => server.close(resolve));
  return port;
}

/** A connection of this machine to itself. @throws Error when nobody takes it */
export function dialLoopback(port: number): Promise<Socket> {
  return new Promise((resolve, reject) => {
    const socket = connect(port, '127.0.0.1');
    socket.once('error', reject);
    socket.once('connect', () => {
      socket.off('error', reject);
      socket.on('error', () => {});
      resolve(socket);
    });
  });
}

/** A port in front of another one that a test can cut. */
export interface CuttablePort {
  readonly port: number;
  /** Breaks every connection, and refuses new ones. */
  cut(): void;
  /** Passes connections again. */
  heal(): void;
  close(): Promise<void>;
}

/** Opens a port of loopback that passes everything to `target`, in both directions. */
export async function openCuttablePort(target: number): Promise<CuttablePort> {
  const sockets = new Set<Socket>();
  let isCut = false;
  const keep = (socket: Socket): void => {
    sockets.add(socket);
    socket.setNoDelay(true);
    socket.on('error', () => undefined);
    socket.once('close', () => sockets.delete(socket));
  };
  const server = createServer((near) => {
    keep(near);
    if (isCut) return void near.destroy();
    const far = connect(target, '127.0.0.1');
    keep(far);
    near.pipe(far).pipe(near);
    near.once('close', () => far.destroy());
    far.once('close', () => near.destroy());
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const cutAll = (): void => sockets.forEach((socket) => void socket.destroy());
  return {
    port: (server.address() as AddressInfo).port,
    cut() {
      isCut = true;
      cutAll();
    },
    heal() {
      isCut = false;
    },
    async close() {
      const closed = new Promise((resolve) => server.close(resolve));
      cutAll();
      await closed;
    },
  };
}
