import { formatNumber } from './format-number.ts';
import { NO_VALUE } from './readout.ts';

/** Formats a rate in Hz: one decimal below 100, none above, `0` without records, a dash when unknown. */
export function formatRate(hz: number | undefined): string {
  if (hz === undefined) return NO_VALUE.digits;
  if (hz < 0.05) return '0';
  return formatNumber(hz, hz < 99.95 ? 1 : 0);
}
