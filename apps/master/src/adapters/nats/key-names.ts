/** NATS takes lines of 4096 bytes, with the name of the bucket and more besides the key. */
const MAX_ENCODED = 3_500;
const PLAIN = /^[A-Za-z0-9_-]$/;

/**
 * The name of a key in a bucket: letters, digits, `_` and `-` as they are, each other byte of its UTF-8 as `=` with two
 * hexadecimal digits. [CU-54]
 *
 * @throws RangeError for a key that is too long for NATS
 */
export function encodeKey(key: string): string {
  // NATS has no empty name.
  if (key === '') return '=';
  let encoded = '';
  for (const char of key) {
    encoded += PLAIN.test(char) ? char : Buffer.from(char).toString('hex').replace(/../g, '=$&');
  }
  if (encoded.length > MAX_ENCODED) {
    throw new RangeError(
      `The name is too long to be stored in NATS: it takes ${encoded.length} bytes there, at most are ${MAX_ENCODED}.`,
    );
  }
  return encoded;
}

/** @returns undefined for a name that `encodeKey` does not make */
export function decodeKey(name: string): string | undefined {
  if (name === '=') return '';
  if (!/^(?:[A-Za-z0-9_-]|=[0-9a-f]{2})+$/.test(name)) return undefined;
  const bytes = name.replace(/=([0-9a-f]{2})/g, (_, digits: string) =>
    String.fromCharCode(Number.parseInt(digits, 16)),
  );
  const key = Buffer.from(bytes, 'latin1').toString('utf8');
  return encodeKey(key) === name ? key : undefined;
}
