import { formatNumber } from './format-number.ts';
import type { Readout } from './readout.ts';

const PREFIXES = ['', 'k', 'M', 'G', 'T'];

/**
 * Formats a size with a decimal prefix (1 kB = 1000 B), two to three digits.
 * @param suffix `B`, `B/s`, or empty where the column heading has it
 */
export function formatBytes(bytes: number, suffix = 'B'): Readout {
  let value = bytes;
  let prefix = 0;
  while (value >= 999.5 && prefix < PREFIXES.length - 1) {
    value /= 1000;
    prefix += 1;
  }
  const decimals = prefix === 0 || value >= 9.95 ? 0 : 1;
  const unit = `${PREFIXES[prefix] ?? ''}${suffix}`;
  return unit === ''
    ? { digits: formatNumber(value, decimals) }
    : { digits: formatNumber(value, decimals), unit };
}
