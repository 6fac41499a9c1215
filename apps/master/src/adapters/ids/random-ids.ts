import { createHash, randomUUID } from 'node:crypto';

import type { IdSource } from '../../core/ports/index.ts';

/** RFC 9562: a name space of our own, and the first 16 bytes of the SHA-1 of it and the name. */
const NAME_SPACE = Buffer.from('7d3b9a5c61f24f0e8c2adf0b5a9e4471', 'hex');
const VERSION_5 = 0x50;
const VARIANT = 0x80;

function named(name: string): string {
  const hash = createHash('sha1').update(NAME_SPACE).update(name, 'utf8').digest();
  hash[6] = (hash[6]! & 0x0f) | VERSION_5;
  hash[8] = (hash[8]! & 0x3f) | VARIANT;
  const hex = hash.toString('hex');
  const ends = [8, 12, 16, 20, 32];
  return ends.map((end, index) => hex.slice(ends[index - 1] ?? 0, end)).join('-');
}

/** Ids from the system's cryptographic random numbers, and from names. */
export const randomIds: IdSource = { uuid: () => randomUUID(), named };
