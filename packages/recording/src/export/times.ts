/** A time as ISO 8601 with nine decimals, UTC. @param timeNs nanoseconds since the Unix epoch */
export function isoTime(timeNs: bigint): string {
  const [seconds] = new Date(Number(timeNs / 1_000_000n)).toISOString().split('.');
  return `${seconds}.${String(timeNs % 1_000_000_000n).padStart(9, '0')}Z`;
}

/** A time in milliseconds since the Unix epoch, with the decimals that it has. */
export function decimalMs(timeNs: bigint): string {
  const decimals = String(timeNs % 1_000_000n)
    .padStart(6, '0')
    .replace(/0+$/, '');
  return `${timeNs / 1_000_000n}${decimals === '' ? '' : `.${decimals}`}`;
}
