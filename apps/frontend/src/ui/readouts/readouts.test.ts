import { describe, expect, it } from 'vitest';
import { formatBytes } from './format-bytes.ts';
import { formatNumber } from './format-number.ts';
import { formatRate } from './format-rate.ts';
import { formatAge, formatMilliseconds, formatRunTime, formatUptime } from './format-time.ts';

const text = ({ digits, unit }: { digits: string; unit?: string }): string =>
  [digits, unit].filter(Boolean).join(' ');

describe('formatNumber', () => {
  it.each([
    [0, 0, '0'],
    [-0.38, 2, '−0.38'],
    [-0.001, 2, '0.00'],
    [1842, 0, '1\u00a0842'],
    [1234567.891, 1, '1\u00a0234\u00a0567.9'],
    [Number.NaN, 2, 'NaN'],
    [-Infinity, 2, '−∞'],
  ])('%d with %d decimals is %s', (value, decimals, expected) => {
    expect(formatNumber(value, decimals)).toBe(expected);
  });
});

describe('formatRate', () => {
  it.each([
    [0, '0'],
    [0.01, '0'],
    [0.1, '0.1'],
    [59.94, '59.9'],
    [99.96, '100'],
    [412.4, '412'],
  ])('%d Hz is %s', (hz, expected) => {
    expect(formatRate(hz)).toBe(expected);
  });
});

describe('formatBytes', () => {
  it.each([
    [0, '0 B'],
    [999, '999 B'],
    [1000, '1.0 kB'],
    [7400, '7.4 kB'],
    [38_200, '38 kB'],
    [999_600, '1.0 MB'],
  ])('%d is %s', (bytes, expected) => {
    expect(text(formatBytes(bytes))).toBe(expected);
  });

  it('leaves the unit out where the head of the column says it', () => {
    expect(formatBytes(12, '')).toEqual({ digits: '12' });
    expect(text(formatBytes(31_000, ''))).toBe('31 k');
  });
});

describe('formatAge', () => {
  it.each([
    [-5, '0 ms'],
    [9.4, '9 ms'],
    [400, '0.4 s'],
    [4800, '4.8 s'],
    [38_900, '38 s'],
    [18 * 60_000, '18 min'],
    [26 * 3_600_000, '26 h'],
    [3 * 86_400_000, '3 d'],
  ])('%d ms is %s', (ageMs, expected) => {
    expect(text(formatAge(ageMs))).toBe(expected);
  });
});

it('a round trip has one decimal under ten', () => {
  expect(text(formatMilliseconds(8.44))).toBe('8.4 ms');
  expect(text(formatMilliseconds(64.4))).toBe('64 ms');
});

describe('formatUptime', () => {
  it.each([
    [38_000, '38 s'],
    [12 * 60_000, '12 min'],
    [4 * 3_600_000 + 7 * 60_000, '4 h 07 min'],
    [3 * 86_400_000 + 4 * 3_600_000, '3 d 04 h'],
  ])('%d ms is %s', (durationMs, expected) => {
    expect(formatUptime(durationMs)).toBe(expected);
  });
});

it('short run times keep two decimals', () => {
  expect([0.001, 0.04, 0.2, 3].map((ms) => text(formatRunTime(ms)))).toEqual([
    '<0.01 ms',
    '0.04 ms',
    '0.2 ms',
    '3.0 ms',
  ]);
});
