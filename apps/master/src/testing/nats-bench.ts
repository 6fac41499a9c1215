import { openCuttablePort, startNats, type NatsServer } from '@ubii/harness';
import { SystemClock } from '@ubii/timing/system';

import { parseCluster } from '../adapters/config/cluster-address.ts';
import { readCredentials } from '../adapters/nats/credentials.ts';
import { NatsLink } from '../adapters/nats/nats-link.ts';
import type { Log } from '../core/ports/log.ts';
import { RecordingLog } from './recording-log.ts';

/** A NATS server and links to it, each of which can be cut. Needs `nats-server`. */
export interface NatsBench {
  readonly server: NatsServer;
  /** Opens a link through a port of its own. */
  openLink(log?: Log): Promise<CuttableLink>;
  /** Closes the links and stops the server. */
  close(): Promise<void>;
}

/** A link that a test can take from its server. */
export interface CuttableLink {
  readonly link: NatsLink;
  cut(): void;
  heal(): void;
}

/** Starts NATS with the key-value stores. */
export async function openNatsBench(): Promise<NatsBench> {
  const server = await startNats({ jetstream: true });
  const closings: (() => Promise<void>)[] = [];
  return {
    server,
    async openLink(log = new RecordingLog()) {
      const port = await openCuttablePort(server.port);
      const link = await openTestLink(`nats://127.0.0.1:${port.port}`, log);
      closings.push(() => link.close().then(() => port.close()));
      return { link, cut: () => port.cut(), heal: () => port.heal() };
    },
    async close() {
      await Promise.all(closings.map((close) => close()));
      await server.stop();
    },
  };
}

/** Opens a link as a master does, with the clock of the system. */
export function openTestLink(
  url: string,
  log: Log = new RecordingLog(),
  startMs?: number,
): Promise<NatsLink> {
  const address = parseCluster(url);
  return NatsLink.open({
    settings: {
      address,
      authenticator: readCredentials(undefined, address),
      authorities: undefined,
      clientName: 'test',
    },
    clock: new SystemClock(),
    log,
    ...(startMs !== undefined && { startMs }),
  });
}
