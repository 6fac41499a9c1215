import { formatNumber } from './format-number.ts';
import type { Readout } from './readout.ts';

const SECOND = 1000;
const MINUTE = 60 * SECOND;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;

/** Formats an age in one unit: `9 ms`, `0.4 s`, `38 s`, `18 min`, `3 h`, `2 d`. */
export function formatAge(ageMs: number): Readout {
  const age = Math.max(0, ageMs);
  if (age < 99.5) return { digits: formatNumber(age), unit: 'ms' };
  if (age < 9.95 * SECOND) return { digits: formatNumber(age / SECOND, 1), unit: 's' };
  if (age < MINUTE) return { digits: formatNumber(Math.floor(age / SECOND)), unit: 's' };
  if (age < HOUR) return { digits: formatNumber(Math.floor(age / MINUTE)), unit: 'min' };
  if (age < 2 * DAY) return { digits: formatNumber(Math.floor(age / HOUR)), unit: 'h' };
  return { digits: formatNumber(Math.floor(age / DAY)), unit: 'd' };
}

/** Formats a measured duration such as a round trip: `0.8 ms`, `8.4 ms`, `64 ms`. */
export function formatMilliseconds(durationMs: number): Readout {
  return { digits: formatNumber(durationMs, durationMs < 9.95 ? 1 : 0), unit: 'ms' };
}

/** Formats an uptime in at most two units: `38 s`, `12 min`, `4 h 07 min`, `3 d 04 h`. */
export function formatUptime(durationMs: number): string {
  const duration = Math.max(0, durationMs);
  const two = (value: number): string => String(value).padStart(2, '0');
  if (duration < MINUTE) return `${Math.floor(duration / SECOND)} s`;
  if (duration < HOUR) return `${Math.floor(duration / MINUTE)} min`;
  if (duration < DAY) {
    return `${Math.floor(duration / HOUR)} h ${two(Math.floor((duration % HOUR) / MINUTE))} min`;
  }
  return `${Math.floor(duration / DAY)} d ${two(Math.floor((duration % DAY) / HOUR))} h`;
}

/** Formats a run time, which may be very short: `<0.01 ms`, `0.04 ms`, `0.8 ms`, `64 ms`. */
export function formatRunTime(durationMs: number): Readout {
  if (durationMs >= 0.095) return formatMilliseconds(durationMs);
  const digits = durationMs < 0.005 ? '<0.01' : formatNumber(durationMs, 2);
  return { digits, unit: 'ms' };
}
