import { hmac } from '@noble/hashes/hmac.js';
import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex, utf8ToBytes } from '@noble/hashes/utils.js';
import type { PseudonymKey } from './pseudonym-key.ts';

/** Hexadecimal digits of a pseudonym; more when another value has the same ones. */
const DIGITS = 6;
const UUID = /^[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}$/i;

/**
 * Replaces values by pseudonyms: `client-7f3a9c` for names, UUIDs for UUIDs, so that topics and patterns with ids keep their
 * form. The digits are the HMAC-SHA-256 of the value: nobody without the key finds the value by trying. The same value has the
 * same pseudonym as long as the key, with its table, is the same; different values never share one.
 */
export class Pseudonyms {
  readonly #key: PseudonymKey;
  readonly #originals: Map<string, string>;
  readonly #known = new Map<string, string>();

  constructor(key: PseudonymKey) {
    this.#key = key;
    this.#originals = new Map(key.originals);
    for (const [pseudonym, original] of this.#originals) {
      const prefix = UUID.test(pseudonym) ? '' : pseudonym.slice(0, pseudonym.lastIndexOf('-'));
      this.#known.set(entryOf(prefix, original), pseudonym);
    }
  }

  /** The key with all pseudonyms given so far, for the key file. */
  get key(): PseudonymKey {
    return { ...this.#key, originals: new Map(this.#originals) };
  }

  /** Returns the pseudonym of a value; an empty one stays empty. @param prefix what the value is, such as `client` */
  of(value: string, prefix: string): string {
    if (value === '') return '';
    const form = UUID.test(value) ? '' : prefix;
    const entry = entryOf(form, value);
    const known = this.#known.get(entry);
    if (known !== undefined) return known;
    const digest = bytesToHex(hmac(sha256, this.#key.key, utf8ToBytes(value)));
    const pseudonym = form === '' ? uuidOf(digest) : this.#free(form, digest);
    this.#known.set(entry, pseudonym);
    this.#originals.set(pseudonym, value);
    return pseudonym;
  }

  #free(prefix: string, digest: string): string {
    let length = DIGITS;
    while (this.#originals.has(`${prefix}-${digest.slice(0, length)}`)) length += 2;
    return `${prefix}-${digest.slice(0, length)}`;
  }
}

function entryOf(prefix: string, value: string): string {
  return `${prefix}\n${value}`;
}

/** A UUID of version 8, RFC 9562 section 5.8: its other 122 bits are the writer's. */
function uuidOf(digest: string): string {
  const variant = '89ab'[parseInt(digest[16]!, 16) & 3]!;
  const digits = `${digest.slice(0, 12)}8${digest.slice(13, 16)}${variant}${digest.slice(17, 32)}`;
  return digits.replace(/^(.{8})(.{4})(.{4})(.{4})/, '$1-$2-$3-$4-');
}
