/** Estimates the memory of a value, bytes. Stops counting at `upTo`. */
export function valueBytes(value: unknown, upTo: number): number {
  if (typeof value === 'string') return 16 + 2 * value.length;
  if (typeof value !== 'object' || value === null) return 8;
  if (ArrayBuffer.isView(value)) return 16 + value.byteLength;
  let bytes = 24;
  for (const child of Array.isArray(value) ? (value as unknown[]) : Object.values(value)) {
    bytes += 8 + (typeof child === 'number' ? 4 : valueBytes(child, upTo - bytes));
    if (bytes > upTo) break;
  }
  return bytes;
}
