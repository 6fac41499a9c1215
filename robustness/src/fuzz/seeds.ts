import { readFileSync } from 'node:fs';
import { join } from 'node:path';

export const SEEDS_FILE = join(
  import.meta.dirname,
  '../../seeds/session-of-the-client-library.json',
);

/** Recorded traffic of a program with the client library; `npm run fuzz -- --record` writes it. */
export interface RecordedTraffic {
  /** Bodies of service requests, binary, base64. */
  readonly requests: readonly string[];
  /** Payloads of binary WebSocket frames, base64. */
  readonly frames: readonly string[];
  /** Payloads of text frames. */
  readonly texts: readonly string[];
}

export function readSeeds(): RecordedTraffic {
  return JSON.parse(readFileSync(SEEDS_FILE, 'utf8')) as RecordedTraffic;
}

export function fromBase64(texts: readonly string[]): Uint8Array[] {
  return texts.map((text) => new Uint8Array(Buffer.from(text, 'base64')));
}
