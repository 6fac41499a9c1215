import type { Clock } from '@ubii/timing';
import type { openStorage } from '../storage/open-storage.ts';
import { NatsDocuments } from './nats-documents.ts';
import { NatsLink } from './nats-link.ts';
import type { Log } from '../../core/ports/index.ts';
import type { ClusterPorts } from '../../core/areas/settings.ts';
import type { ClusterAddress } from '../config/cluster-address.ts';
import { keepClusterKey, readOrCreateClusterKey } from './cluster-key.ts';
import { HmacMessageSeal } from './cluster-key.ts';
import { readAuthorities, readCredentials } from './credentials.ts';
import { NatsBus } from './nats-bus.ts';
import { requireTls, watchExposure } from './nats-exposure.ts';
import { NatsOwners } from './nats-owners.ts';

/** The stores that all masters share; studies are those of one master. */
export type Storage = Omit<ReturnType<typeof openStorage>, 'studyStorage'>;

/** Name of a bucket. No cluster has `_` in its name, so that no two clusters share a bucket. [CU-54] */
export function bucketOf(cluster: string, kind: string): string {
  return `ubii_${cluster}_${kind}`;
}

/** The stores of a cluster: the same documents for every master, in buckets of NATS. [CU-54] */
async function openClusterStorage(
  link: NatsLink,
  cluster: string,
): Promise<Storage & { close(): void }> {
  const opened: NatsDocuments[] = [];
  const open = async (kind: string): Promise<NatsDocuments> => {
    const store = await NatsDocuments.open(link, bucketOf(cluster, kind));
    opened.push(store);
    return store;
  };
  const close = (): void => opened.forEach((store) => store.close());
  try {
    const [sessions, modules, running, history, grants, personalData] = await Promise.all([
      open('sessions'),
      open('modules'),
      open('running'),
      open('history'),
      open('grants'),
      open('personal-data'),
    ]);
    return {
      sessions,
      modules,
      running,
      history,
      grants,
      personalData,
      async settled() {
        await Promise.all(opened.map((store) => store.settled()));
      },
      close,
    };
  } catch (error) {
    // Those that are still being opened end with the link.
    close();
    throw error;
  }
}

/** Bytes that masters put around the largest frame of a client. */
const AROUND_FRAME_BYTES = 1024 * 1024;

/** A cluster that this master is to join. */
export interface ClusterOptions {
  readonly address: ClusterAddress;
  readonly name: string;
  readonly credentialsFile: string | undefined;
  readonly caFile: string | undefined;
  /** NATS may be open to programs of other machines. [CU-64] Default: false */
  readonly isInsecureAccepted?: boolean;
  /** Name of this master, which NATS shows. */
  readonly masterName: string;
  /** Largest message of a client, bytes. */
  readonly frameBytes: number;
  readonly clock: Clock;
  readonly log: Log;
  /** How long a start waits for NATS, milliseconds. Default: 10 000 */
  readonly startMs?: number;
}

/** What a master of a cluster has from it. */
export interface OpenCluster {
  /** The secret that all masters share. [CU-56] */
  readonly key: Uint8Array;
  readonly storage: Storage;
  readonly cluster: ClusterPorts;
  /** Resolves when all that was written and sent has reached NATS, or cannot. */
  close(): Promise<void>;
}

/**
 * Connects to NATS and opens what the masters of a cluster share. [CU-60] [CU-61] [CU-64]
 *
 * @throws ConfigError that says what to do when NATS cannot be used
 */
export async function openCluster(options: ClusterOptions): Promise<OpenCluster> {
  const { address, name, clock, log, startMs, isInsecureAccepted = false } = options;
  const authorities = options.caFile === undefined ? undefined : readAuthorities(options.caFile);
  const exposure = { address, authorities, isAccepted: isInsecureAccepted };
  requireTls(exposure);
  const link = await NatsLink.open({
    settings: {
      address,
      authenticator: readCredentials(options.credentialsFile, address),
      authorities,
      clientName: `ubii-master ${options.masterName}`,
    },
    clock,
    log: log.child({ cluster: name }),
    ...(startMs !== undefined && { startMs }),
  });
  try {
    const cancelWatch = watchExposure(link, exposure);
    const [storage, owners] = await Promise.all([
      openClusterStorage(link, name),
      NatsOwners.open(link, bucketOf(name, 'owners')),
    ]);
    const key = await readOrCreateClusterKey(link, bucketOf(name, 'keys'));
    const cancelKeep = keepClusterKey(link, bucketOf(name, 'keys'), key);
    const bus = new NatsBus(link, name, options.frameBytes + AROUND_FRAME_BYTES);
    return {
      key,
      storage,
      cluster: { name, bus, seal: new HmacMessageSeal(key), owners },
      async close() {
        cancelWatch();
        cancelKeep();
        await Promise.all([storage.settled(), bus.close()]);
        storage.close();
        owners.close();
        await link.close();
      },
    };
  } catch (error) {
    await link.close();
    throw error;
  }
}
