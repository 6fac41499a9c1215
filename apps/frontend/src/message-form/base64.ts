/** Largest file in a record, bytes. */
export const MAX_FILE_BYTES = 2_000_000;

/** Number of arguments of `String.fromCharCode` that all browsers support. */
const CHUNK = 8192;

/** Encodes bytes as base64, as in JSON messages. */
export function base64Of(bytes: Uint8Array): string {
  let binary = '';
  for (let from = 0; from < bytes.length; from += CHUNK) {
    binary += String.fromCharCode(...bytes.subarray(from, from + CHUNK));
  }
  return btoa(binary);
}
