/** Larger files are not made into one record. */
export const MAX_FILE_BYTES = 2_000_000;

/** `String.fromCharCode` takes so many arguments at most, everywhere. */
const CHUNK = 8192;

/** Bytes as JSON carries them. */
export function base64Of(bytes: Uint8Array): string {
  let binary = '';
  for (let from = 0; from < bytes.length; from += CHUNK) {
    binary += String.fromCharCode(...bytes.subarray(from, from + CHUNK));
  }
  return btoa(binary);
}
