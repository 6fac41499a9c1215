import { ConfigError } from '@ubii/program';

import { createTokenKey, parseTokenKey, TOKEN_KEY_BYTES } from '../tokens/token-key.ts';
import { explainStores } from './explain-nats-error.ts';
import { KvBucket, type KvEntry } from './kv-bucket.ts';
import type { NatsLink } from './nats-link.ts';

const KEY = 'token-key';

/**
 * The secret of a cluster, from which resume tokens and credentials are derived: the first master creates it, and all
 * read it, so that what one issues every other accepts. [CU-56]
 *
 * @throws ConfigError when NATS holds something else, or cannot be used
 */
export async function readOrCreateClusterKey(link: NatsLink, bucket: string): Promise<Uint8Array> {
  const keys = new KvBucket(link, bucket);
  let entry: KvEntry | undefined;
  try {
    await keys.ensure();
    entry = await keys.read(KEY);
    if (entry?.value === undefined) {
      // Two masters may start at once: the key of the first one stays.
      await keys.write(KEY, Buffer.from(createTokenKey()), entry?.revision ?? 0);
      entry = await keys.read(KEY);
    }
  } catch (error) {
    throw explainStores(error);
  }
  const key = parseTokenKey(Buffer.from(entry?.value ?? []).toString('utf8'));
  if (key !== undefined) return key;
  throw new ConfigError(
    `The key ${KEY} in the bucket ${bucket} of NATS must hold ${TOKEN_KEY_BYTES} bytes in hexadecimal, but does not. Delete it and start all masters again; every client then joins as a new one.`,
  );
}
