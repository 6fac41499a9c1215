import { formatNumber } from './format-number.ts';

/** A rate in Hz: one decimal under 100, none above, a plain 0 when nothing comes. */
export function formatRate(hz: number): string {
  if (hz < 0.05) return '0';
  return formatNumber(hz, hz < 99.95 ? 1 : 0);
}
