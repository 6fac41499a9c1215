import { expect, it } from 'vitest';
import { formatClock, formatDay, formatMoment, formatSeconds } from './format-clock.ts';

const time = new Date(2026, 0, 2, 9, 4, 7, 18).getTime();

it('a time of the day has 24 hours and two digits each', () => {
  expect(formatClock(time)).toBe('09:04:07');
  expect(formatClock(time, 'minute')).toBe('09:04');
  expect(formatClock(time, 'millisecond')).toBe('09:04:07.018');
  expect(formatClock(new Date(2026, 0, 2, 0, 0, 0).getTime())).toBe('00:00:00');
});

it('seconds stand alone where the minute is in the head of a column', () => {
  expect(formatSeconds(time)).toBe('07.018');
  expect(formatSeconds(time, 'second')).toBe('07');
});

it('a moment begins with its day', () => {
  expect(formatDay(time)).toBe('2 Jan 2026');
  expect(formatMoment(time)).toBe('2 Jan 2026 09:04:07');
  expect(formatMoment(time, 'minute')).toBe('2 Jan 2026 09:04');
});
