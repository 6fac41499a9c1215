import { randomInt } from 'node:crypto';
import { createServer, type AddressInfo } from 'node:net';

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
