import { bytesToHex, hexToBytes } from '@noble/hashes/utils.js';
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
