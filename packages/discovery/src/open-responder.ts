import { networkInterfaces, type NetworkInterfaceInfo } from 'node:os';
import type { EventEmitter } from 'node:events';

import Bonjour from 'bonjour-service';

/** One IPv4 address of this machine for each network it is in. */
export function ownAddresses(
  interfaces: NodeJS.Dict<NetworkInterfaceInfo[]> = networkInterfaces(),
): readonly string[] {
  return Object.values(interfaces).flatMap((addresses = []) => {
    const first = addresses.find(({ family, internal }) => family === 'IPv4' && !internal);
    return first === undefined ? [] : [first.address];
  });
}

/** Destination of multicast DNS. */
export interface MulticastOptions {
  /** IPv4 addresses of this machine, one for each network to speak in. */
  readonly addresses: () => readonly string[];
  /** @default 5353; another one is for tests, which must not be heard by others */
  readonly port?: number;
}

/** A record as the library reads it. */
export interface ReceivedRecord {
  readonly type: string;
  readonly name: string;
  readonly data: unknown;
  readonly ttl?: number;
}

/** The part of the library's server that is used and missing in its type declarations. */
interface Mdns extends EventEmitter {
  query(name: string, type: string): void;
}

/** One network, and the library that speaks in it. */
export interface Responder {
  readonly bonjour: Bonjour;
  /** Calls `fn` with the records of each response heard, one's own included. */
  onResponse(fn: (records: readonly ReceivedRecord[]) => void): void;
  query(name: string, type: 'PTR' | 'ANY'): void;
  /** Ends silently; resolves when the socket is closed. */
  close(): Promise<void>;
}

/**
 * Opens multicast DNS in one network. What goes wrong later is told to `onError` and throws nowhere:
 * a port that is taken, a network without multicast, one that goes away.
 * @param address IPv4 address of this machine in that network
 */
export function openResponder(
  address: string,
  port: number | undefined,
  onError: (reason: string) => void,
): Responder | undefined {
  // Without an error there is nothing to be told; the library calls back after each attempt to send.
  const handleError = (error: unknown): void => {
    if (error instanceof Error) onError(`${address}: ${error.message}`);
  };
  try {
    const options = {
      interface: address,
      // The address alone would hear no multicast.
      bind: '0.0.0.0',
      ...(port === undefined ? {} : { port }),
    };
    const bonjour = new Bonjour(options as object, handleError);
    const { mdns } = (bonjour as unknown as { server: { mdns: Mdns } }).server;
    mdns.on('error', handleError);
    mdns.on('warning', () => undefined); // packets that cannot be read, networks without multicast
    let isClosed = false;
    return {
      bonjour,
      onResponse(fn) {
        mdns.on('response', (packet: Record<'answers' | 'additionals', ReceivedRecord[]>) =>
          fn([...packet.answers, ...packet.additionals]),
        );
      },
      query: (name, type) => mdns.query(name, type),
      close: () =>
        new Promise((resolve) => {
          if (isClosed) return resolve();
          isClosed = true;
          try {
            bonjour.destroy(() => resolve());
          } catch {
            resolve(); // it never came to be open
          }
        }),
    };
  } catch (error) {
    handleError(error);
    return undefined;
  }
}
