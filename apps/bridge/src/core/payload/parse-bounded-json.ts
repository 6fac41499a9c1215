import { JsonScan } from '@ubii/proto';
import { BRIDGE_LIMITS } from '../limits.ts';

const utf8 = new TextDecoder('utf-8', { fatal: true });

/** @throws Error when the bytes are not text */
export function readText(bytes: Uint8Array): string {
  try {
    return utf8.decode(bytes);
  } catch {
    throw new Error('The message is not text in UTF-8.');
  }
}

/**
 * Parses JSON of strangers: its depth and its number of values are looked at before. [BR-30]
 *
 * @throws Error with the reason
 */
export function parseBoundedJson(bytes: Uint8Array): unknown {
  const scan = new JsonScan('');
  const excess = scan.scan(bytes, bytes.length, {
    depth: BRIDGE_LIMITS.jsonDepth,
    values: BRIDGE_LIMITS.jsonValues,
  });
  if (excess === 'depth') {
    throw new Error(`The JSON has more than ${BRIDGE_LIMITS.jsonDepth} levels.`);
  }
  if (excess === 'values') {
    throw new Error(`The JSON has more than ${BRIDGE_LIMITS.jsonValues} values.`);
  }
  try {
    return JSON.parse(readText(bytes));
  } catch (error) {
    throw new Error(`The message is not JSON: ${(error as Error).message}.`, { cause: error });
  }
}
