const BLOCK_BYTES = 4 * 1024 * 1024;
const MIN_MATCH = 4;

/**
 * An LZ4 frame of the same bytes again and again, made without compressing: about one byte for 255.
 *
 * @param pattern of 5 to 65 535 bytes
 */
export function repeatedLz4(pattern: Uint8Array, count: number): Uint8Array {
  const perBlock = Math.floor(BLOCK_BYTES / pattern.length);
  const parts: Uint8Array[] = [Uint8Array.of(0x04, 0x22, 0x4d, 0x18, 0x60, 0x70, 0x73)];
  const fullBlock = blockOf(pattern, perBlock);
  for (let left = count; left > 0; left -= perBlock) {
    parts.push(left >= perBlock ? fullBlock : blockOf(pattern, left));
  }
  parts.push(new Uint8Array(4));
  const bytes = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

/** Size of the block; the pattern, a match of all others, and the last one as literals, as the format wants. */
function blockOf(pattern: Uint8Array, count: number): Uint8Array {
  const bytes: number[] = [0, 0, 0, 0];
  const matched = (count - 2) * pattern.length;
  if (matched >= MIN_MATCH) {
    writeToken(bytes, pattern.length, matched - MIN_MATCH);
    bytes.push(...pattern, pattern.length & 0xff, pattern.length >>> 8);
    writeLength(bytes, matched - MIN_MATCH);
  }
  const rest = matched >= MIN_MATCH ? [pattern] : Array.from({ length: count }, () => pattern);
  writeToken(bytes, rest.length * pattern.length, 0);
  for (const part of rest) bytes.push(...part);
  const block = Uint8Array.from(bytes);
  new DataView(block.buffer).setUint32(0, block.length - 4, true);
  return block;
}

/** The token and the length of the literals. */
function writeToken(bytes: number[], literals: number, extra: number): void {
  bytes.push((Math.min(literals, 15) << 4) | Math.min(extra, 15));
  writeLength(bytes, literals);
}

function writeLength(bytes: number[], length: number): void {
  if (length < 15) return;
  let rest = length - 15;
  for (; rest >= 255; rest -= 255) bytes.push(255);
  bytes.push(rest);
}
