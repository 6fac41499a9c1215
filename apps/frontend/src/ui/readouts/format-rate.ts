import { formatNumber } from './format-number.ts';
import { NO_VALUE } from './readout.ts';

/** A rate in Hz: one decimal under 100, none above, a plain 0 when nothing comes, a dash while it is not known. */
export function formatRate(hz: number | undefined): string {
  if (hz === undefined) return NO_VALUE.digits;
  if (hz < 0.05) return '0';
  return formatNumber(hz, hz < 99.95 ? 1 : 0);
}
