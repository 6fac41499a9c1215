import { bytesToHex, hexToBytes, utf8ToBytes } from '@noble/hashes/utils.js';
import { hmac } from '@noble/hashes/hmac.js';
import { sha256 } from '@noble/hashes/sha2.js';

import { RecordingError } from '../records/recording-error.ts';

const KIND = 'ubi-interact-pseudonyms';
const VERSION = 1;
const KEY_BYTES = 32;
const DAY_MS = 86_400_000;
/** Times are moved back by at least a year, at most ten. */
const [MIN_SHIFT_DAYS, MAX_SHIFT_DAYS] = [365, 3650];

/** What re-identifies people in shared recordings. It is kept apart from them. */
export interface PseudonymKey {
  /** 32 random bytes. */
  readonly key: Uint8Array;
  /** Added to absolute times when they are shifted, milliseconds; a whole negative number. */
  readonly shiftMs: number;
  /** What each pseudonym stands for. */
  readonly originals: ReadonlyMap<string, string>;
}

/** Makes a new key. @param random fills an array with random bytes, such as `crypto.getRandomValues` */
export function createPseudonymKey(random: (bytes: Uint8Array<ArrayBuffer>) => void): PseudonymKey {
  const bytes = new Uint8Array(KEY_BYTES + 4);
  random(bytes);
  const part = new DataView(bytes.buffer).getUint32(KEY_BYTES) / 2 ** 32;
  const days = MIN_SHIFT_DAYS + part * (MAX_SHIFT_DAYS - MIN_SHIFT_DAYS);
  const shiftMs = -Math.floor(days * DAY_MS);
  return { key: bytes.slice(0, KEY_BYTES), shiftMs, originals: new Map() };
}

/** Formats the key file. */
export function formatPseudonymKey({ key, shiftMs, originals }: PseudonymKey): string {
  const pseudonyms = Object.fromEntries([...originals].sort(([a], [b]) => (a < b ? -1 : 1)));
  const file = { kind: KIND, version: VERSION, key: bytesToHex(key), shiftMs, pseudonyms };
  return `${JSON.stringify(file, undefined, 2)}\n`;
}

/** Parses a key file. @throws RecordingError when it is none */
export function parsePseudonymKey(text: string): PseudonymKey {
  const file = parseObject(text);
  if (file['kind'] !== KIND) throw new RecordingError('This is no key file of pseudonyms.');
  if (file['version'] !== VERSION) {
    throw new RecordingError(
      `The key file has version ${String(file['version'])}, this program reads ${VERSION}.`,
    );
  }
  const { key: keyText, shiftMs, pseudonyms } = file;
  const key = typeof keyText === 'string' ? parseHex(keyText) : undefined;
  const isWhole = key?.length === KEY_BYTES && Number.isSafeInteger(shiftMs);
  if (!isWhole || typeof pseudonyms !== 'object' || pseudonyms === null) {
    throw new RecordingError('The key file is damaged: its key, shift or table is missing.');
  }
  const rows = Object.entries(pseudonyms).filter(([, original]) => typeof original === 'string');
  return { key, shiftMs: shiftMs as number, originals: new Map(rows as [string, string][]) };
}

function parseObject(text: string): Readonly<Record<string, unknown>> {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null ? { ...value } : {};
  } catch {
    return {};
  }
}

function parseHex(text: string): Uint8Array | undefined {
  try {
    return hexToBytes(text);
  } catch {
    return undefined;
  }
}

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
