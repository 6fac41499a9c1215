import type { AddressInfo, Server } from 'node:net';

/** A port on which the master listens. */
export interface OpenPort {
  readonly port: number;
  readonly servers: readonly Server[];
}

/** The name that stands for both loopback addresses. */
const LOCALHOST = 'localhost';
/** Every address of every network, IPv6 and IPv4. */
export const ALL_NETWORKS = '::';

const ATTEMPTS_FOR_ANY_PORT = 5;

/**
 * Listens on one port of one host. `localhost` means both loopback addresses with the same port, so
 * that it does not matter which of them a client tries first.
 *
 * @param port 0 takes any free one
 * @throws the system's error when the port cannot be had
 */
export async function openPort(
  port: number,
  host: string,
  createServer: () => Server,
): Promise<OpenPort> {
  if (host !== LOCALHOST) {
    const server = await listen(createServer(), port, host).catch((error: unknown) => {
      if (host === ALL_NETWORKS && isMissingAddress(error)) {
        return listen(createServer(), port, '0.0.0.0');
      }
      throw error;
    });
    return { port: portOf(server), servers: [server] };
  }
  for (let attempt = 1; ; attempt += 1) {
    const first = await listen(createServer(), port, '127.0.0.1');
    try {
      const second = await listen(createServer(), portOf(first), '::1');
      return { port: portOf(first), servers: [first, second] };
    } catch (error) {
      // A machine without IPv6 has one loopback address only.
      if (isMissingAddress(error)) return { port: portOf(first), servers: [first] };
      first.close();
      if (port !== 0 || attempt === ATTEMPTS_FOR_ANY_PORT) throw error;
    }
  }
}

function listen(server: Server, port: number, host: string): Promise<Server> {
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen({ port, host }, () => {
      server.off('error', reject);
      resolve(server);
    });
  });
}

function portOf(server: Server): number {
  return (server.address() as AddressInfo).port;
}

function isMissingAddress(error: unknown): boolean {
  return ['EADDRNOTAVAIL', 'EAFNOSUPPORT', 'EINVAL'].includes(
    String((error as NodeJS.ErrnoException).code),
  );
}
