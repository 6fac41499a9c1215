/** Largest file in a record, bytes. */
export const MAX_FILE_BYTES = 2_000_000;

/** Number of arguments of `String.fromCharCode` that all browsers support. */
const CHUNK = 8192;

/** Decodes base64 of JSON messages; undefined for other text. */
export function bytesOfBase64(text: string): Uint8Array | undefined {
  try {
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    return undefined;
  }
}

/** Encodes bytes as base64, as in JSON messages. */
export function base64Of(bytes: Uint8Array): string {
  let binary = '';
  for (let from = 0; from < bytes.length; from += CHUNK) {
    binary += String.fromCharCode(...bytes.subarray(from, from + CHUNK));
  }
  return btoa(binary);
}
