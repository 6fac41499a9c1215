/** Precision of a time of day. */
export type ClockPrecision = 'minute' | 'second' | 'millisecond';

const MONTHS = 'Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec'.split(' ');
const two = (value: number): string => String(value).padStart(2, '0');

/** Formats a local time: `12:41`, `12:41:07`, `12:41:07.218`. */
export function formatClock(timeMs: number, precision: ClockPrecision = 'second'): string {
  const time = new Date(timeMs);
  const minute = `${two(time.getHours())}:${two(time.getMinutes())}`;
  return precision === 'minute' ? minute : `${minute}:${formatSeconds(timeMs, precision)}`;
}

/** Seconds within the minute: `07`, `07.218`. */
export function formatSeconds(
  timeMs: number,
  precision: Exclude<ClockPrecision, 'minute'> = 'millisecond',
): string {
  const time = new Date(timeMs);
  const seconds = two(time.getSeconds());
  if (precision === 'second') return seconds;
  return `${seconds}.${String(time.getMilliseconds()).padStart(3, '0')}`;
}

/** Formats a local date: `2 Jan 2026`. */
export function formatDay(timeMs: number): string {
  const time = new Date(timeMs);
  return `${time.getDate()} ${MONTHS[time.getMonth()]} ${time.getFullYear()}`;
}

/** Formats a local date and time: `2 Jan 2026 12:41:07`. */
export function formatMoment(timeMs: number, precision: ClockPrecision = 'second'): string {
  return `${formatDay(timeMs)} ${formatClock(timeMs, precision)}`;
}
