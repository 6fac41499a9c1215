/** Line of a hex dump. */
export interface HexRow {
  /** Offset of its first byte. */
  readonly offset: number;
  /** `00000010` */
  readonly address: string;
  /** Two digits per byte. */
  readonly hex: readonly string[];
  /** Non-printable characters as a dot. */
  readonly text: readonly string[];
}

/** Most bytes listed; of longer values, the first ones. */
export const MAX_BYTES = 1 << 20;

const HEX = Array.from({ length: 256 }, (_none, byte) => byte.toString(16).padStart(2, '0'));
const LETTERS = Array.from({ length: 256 }, (_none, byte) =>
  byte >= 0x20 && byte < 0x7f ? String.fromCharCode(byte) : '·',
);

export function hexRow(bytes: Uint8Array, row: number, perRow: number): HexRow {
  const offset = row * perRow;
  const part = [...bytes.subarray(offset, offset + perRow)];
  return {
    offset,
    address: offset.toString(16).padStart(8, '0'),
    hex: part.map((byte) => HEX[byte]!),
    text: part.map((byte) => LETTERS[byte]!),
  };
}

/** First and last byte, both included, in either order. */
export interface ByteSelection {
  readonly anchor: number;
  readonly end: number;
}

export function selected(
  bytes: Uint8Array,
  { anchor, end }: ByteSelection,
): { readonly from: number; readonly bytes: Uint8Array } {
  const from = Math.min(anchor, end);
  return { from, bytes: bytes.subarray(from, Math.max(anchor, end) + 1) };
}

/** `0a ff 00` */
export const hexText = (bytes: Uint8Array): string =>
  [...bytes].map((byte) => HEX[byte]!).join(' ');

/** Returns the byte that a key moves the cursor to; undefined for other keys. */
export function afterKey(
  key: string,
  at: number,
  perRow: number,
  count: number,
): number | undefined {
  const step = STEPS[key]?.(at, perRow, count);
  return step === undefined ? undefined : Math.max(0, Math.min(count - 1, step));
}

const PAGE_ROWS = 16;
const STEPS: Readonly<Record<string, (at: number, perRow: number, count: number) => number>> = {
  ArrowLeft: (at) => at - 1,
  ArrowRight: (at) => at + 1,
  ArrowUp: (at, perRow) => (at < perRow ? at : at - perRow),
  ArrowDown: (at, perRow, count) => (at + perRow < count ? at + perRow : at),
  PageUp: (at, perRow) => at - perRow * PAGE_ROWS,
  PageDown: (at, perRow) => at + perRow * PAGE_ROWS,
  Home: () => 0,
  End: (_at, _perRow, count) => count - 1,
};

/** Interprets the bytes as numbers, little-endian as in Protocol Buffers. */
export function asNumbers(bytes: Uint8Array): { readonly name: string; readonly text: string }[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const found = [];
  if (bytes.length === 1) found.push({ name: 'int', text: String(view.getUint8(0)) });
  if (bytes.length === 2) found.push({ name: 'int16', text: String(view.getInt16(0, true)) });
  if (bytes.length === 4) {
    found.push({ name: 'int32', text: String(view.getInt32(0, true)) });
    found.push({ name: 'float', text: String(Number(view.getFloat32(0, true).toPrecision(7))) });
  }
  if (bytes.length === 8) found.push({ name: 'double', text: String(view.getFloat64(0, true)) });
  return found.map(({ name, text }) => ({ name, text: text.replaceAll('-', '−') }));
}
