const MINUS = '−';
/** Non-breaking space. */
const GROUP = '\u00a0';

/**
 * Formats a number with fixed decimals, a minus sign, and groups of three digits from 1 000 on. No minus for values
 * that round to zero; NaN and infinity as their names.
 */
export function formatNumber(value: number, decimals = 0): string {
  if (Number.isNaN(value)) return 'NaN';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : `${MINUS}∞`;
  const [whole = '0', fraction] = Math.abs(value).toFixed(decimals).split('.');
  // Fast path for short numbers, as some are formatted a thousand times a second.
  const grouped = whole.length > 3 ? whole.replace(/\B(?=(\d{3})+(?!\d))/g, GROUP) : whole;
  const digits = fraction === undefined ? grouped : `${grouped}.${fraction}`;
  return value < 0 && /[1-9]/.test(digits) ? `${MINUS}${digits}` : digits;
}
