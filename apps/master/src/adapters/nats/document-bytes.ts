import { promisify } from 'node:util';
import { gunzipSync, gzip } from 'node:zlib';
import type { JsonObject } from '@ubii/proto';

import type { StoredDocument } from '../../core/ports/index.ts';

const compress = promisify(gzip);

/** From this size on documents are compressed, bytes: NATS takes 1 MiB by default, and code shrinks to a fifth. */
const COMPRESSED_FROM = 32 * 1024;
/** Largest document that is read, bytes, as for files. */
const MAX_BYTES = 32 * 1024 * 1024;

/** The bytes of a document: JSON, with gzip when it is large. [CU-54] */
export async function documentBytes(json: JsonObject): Promise<Uint8Array> {
  const text = Buffer.from(JSON.stringify(json));
  return text.byteLength < COMPRESSED_FROM ? text : compress(text);
}

/** Reads what another master or program wrote, which may be anything. */
export function readDocument(bytes: Uint8Array): StoredDocument {
  try {
    const isGzip = bytes[0] === 0x1f && bytes[1] === 0x8b;
    const text = isGzip ? gunzipSync(bytes, { maxOutputLength: MAX_BYTES }) : Buffer.from(bytes);
    return { json: JSON.parse(text.toString('utf8')) as unknown };
  } catch (error) {
    return { fault: error instanceof Error ? error.message : String(error) };
  }
}
