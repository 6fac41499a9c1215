import type { Clock } from '@ubii/timing';

import type { Config } from './adapters/config/config.ts';
import { openStorage, openStudies } from './adapters/storage/open-storage.ts';
import { deriveKey } from './adapters/tokens/token-key.ts';
import { readOrCreateTokenKey } from './adapters/tokens/token-key.ts';
import type { ClusterPorts } from './core/areas/settings.ts';
import type { Log } from './index.ts';

/** What a master keeps between runs. */
export interface MasterStores {
  /** The secret that tokens and credentials are derived from. */
  readonly key: Uint8Array;
  readonly storage: ReturnType<typeof openStorage>;
  /** The other masters; undefined when this one is alone. */
  readonly cluster?: ClusterPorts;
  /** Tells this installation apart from others of the cluster, the same in later runs. [CU-27] */
  readonly installation?: string;
  /** Resolves when all that was written is stored, or cannot be. */
  close(): Promise<void>;
}

/**
 * Opens what a master keeps: in its data directory, or with `--cluster` in NATS, for all masters of the cluster. [CU-54]
 *
 * @throws ConfigError when it cannot be had
 */
export async function openStores(
  config: Config,
  frameBytes: number,
  { clock, log }: { readonly clock: Clock; readonly log: Log },
): Promise<MasterStores> {
  if (config.cluster === undefined) {
    const storage = openStorage(config.dataDir);
    return {
      key: readOrCreateTokenKey(config.dataDir),
      storage,
      close: () => storage.settled(),
    };
  }
  // A master on its own does not load NATS.
  const { openCluster } = await import('./adapters/nats/open-cluster.ts');
  const cluster = await openCluster({
    address: config.cluster,
    name: config.clusterName,
    credentialsFile: config.clusterCredentials,
    caFile: config.clusterCa,
    isInsecureAccepted: config.clusterInsecure,
    masterName: config.name,
    frameBytes,
    clock,
    log,
  });
  // Studies belong to the master that leads them. [CU-54]
  const { studyStorage, settled } = openStudies(config.dataDir);
  const ownKey = readOrCreateTokenKey(config.dataDir, 'installation.key');
  return {
    ...cluster,
    storage: { ...cluster.storage, studyStorage },
    async close() {
      await Promise.all([cluster.close(), settled()]);
    },
    installation: Buffer.from(deriveKey(ownKey, 'installation')).toString('hex'),
  };
}
