const MINUS = '−';
/** Keeps a number on one line. */
const GROUP = '\u00a0';

/**
 * Fixed decimals, a real minus, groups of three from 1 000 on. A value that rounds to zero has no
 * minus; what is not a number keeps its name.
 */
export function formatNumber(value: number, decimals = 0): string {
  if (Number.isNaN(value)) return 'NaN';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : `${MINUS}∞`;
  const [whole = '0', fraction] = Math.abs(value).toFixed(decimals).split('.');
  // Most numbers are short, and some are written a thousand times a second.
  const grouped = whole.length > 3 ? whole.replace(/\B(?=(\d{3})+(?!\d))/g, GROUP) : whole;
  const digits = fraction === undefined ? grouped : `${grouped}.${fraction}`;
  return value < 0 && /[1-9]/.test(digits) ? `${MINUS}${digits}` : digits;
}
