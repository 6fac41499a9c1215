import { formatNumber } from '../readouts/format-number.ts';

const THOUSANDS: readonly (readonly [number, string])[] = [
  [1e9, 'G'],
  [1e6, 'M'],
  [1e4, 'k'],
];

/** Formats a number of an axis in its shortest form: `0.05`, `12`, `25k`. */
export function formatAxisNumber(value: number): string {
  const size = Math.abs(value);
  for (const [from, prefix] of THOUSANDS) {
    const unit = from === 1e4 ? 1e3 : from;
    if (size >= from) return trim(value / unit, 1) + prefix;
  }
  if (size >= 10 || size === 0) return trim(value, 1);
  return trim(value, size >= 1 ? 1 : size >= 0.1 ? 2 : 3);
}

function trim(value: number, decimals: number): string {
  return formatNumber(Number(value.toFixed(decimals)), decimals).replace(/\.?0+$/, (zeros) =>
    zeros.startsWith('.') ? '' : decimals === 0 ? zeros : '',
  );
}
