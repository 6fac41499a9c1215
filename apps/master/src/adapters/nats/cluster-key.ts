import { createHmac, timingSafeEqual } from 'node:crypto';
import { ConfigError } from '@ubii/program';
import type { Cancel } from '@ubii/timing';
import type { MessageSeal } from '../../core/ports/index.ts';
import { deriveKey, createTokenKey, parseTokenKey, TOKEN_KEY_BYTES } from '../tokens/token-key.ts';
import { explainStores, reasonOf } from './explain-nats-error.ts';
import { KvBucket, type KvEntry } from './kv-bucket.ts';
import type { NatsLink } from './nats-link.ts';

/** Proofs with a key made from that of the cluster, which signs nothing else. [CU-65] */
export class HmacMessageSeal implements MessageSeal {
  readonly #key: Uint8Array;

  /** @param key the secret of the cluster, at least 32 random bytes */
  constructor(key: Uint8Array) {
    this.#key = deriveKey(key, 'cluster messages');
  }

  prove(from: string, to: string, message: Uint8Array): Uint8Array {
    // Ids of masters have no line ends.
    return createHmac('sha256', this.#key).update(`${from}\n${to}\n`).update(message).digest();
  }

  verify(from: string, to: string, message: Uint8Array, proof: Uint8Array): boolean {
    const expected = this.prove(from, to, message);
    return proof.byteLength === expected.byteLength && timingSafeEqual(proof, expected);
  }
}

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

/**
 * Writes the secret back whenever NATS comes back without it, because its storage was lost: a master that starts then
 * would make another one, and turn away all clients of the others. [CU-56]
 */
export function keepClusterKey(link: NatsLink, bucket: string, key: Uint8Array): Cancel {
  const keys = new KvBucket(link, bucket);
  const restore = async (): Promise<void> => {
    await keys.ensure();
    const entry = await keys.read(KEY);
    if (entry === undefined)
      await keys.write(KEY, Buffer.from(Buffer.from(key).toString('hex')), 0);
    const stored = await keys.read(KEY);
    if (stored?.value === undefined || isSame(stored.value, key)) return;
    link.log.error('NATS has another key than this master; start all masters again', { bucket });
  };
  return link.onReach((isConnected) => {
    if (!isConnected) return;
    restore().catch((error: unknown) => {
      link.log.warn('the key of the cluster could not be looked for', { reason: reasonOf(error) });
    });
  });
}

function isSame(stored: Uint8Array, key: Uint8Array): boolean {
  const parsed = parseTokenKey(Buffer.from(stored).toString('utf8'));
  return parsed !== undefined && Buffer.compare(parsed, key) === 0;
}
