import { describe, expect, it } from 'vitest';
import { formatLength, formatPlace, rulerTicks } from './recording-time.ts';

describe('times of a recording', () => {
  it('are minutes and seconds, with hours where there are some', () => {
    expect(formatLength(846_204)).toBe('14:06');
    expect(formatLength(3_858_000)).toBe('1:04:18');
    expect(formatPlace(258_318.4)).toBe('4:18.318');
    expect(formatPlace(59_999.6)).toBe('1:00.000');
  });
});

describe('rulerTicks()', () => {
  it('names round moments, with one line between two', () => {
    const ticks = rulerTicks({ fromMs: 239_000, untilMs: 277_000 }, 866);
    const named = ticks.flatMap(({ text }) => text ?? []);
    expect(named).toEqual([
      '4:00',
      '4:04',
      '4:08',
      '4:12',
      '4:16',
      '4:20',
      '4:24',
      '4:28',
      '4:32',
      '4:36',
    ]);
    expect(ticks.length).toBeGreaterThan(named.length);
  });

  it('writes milliseconds where lines are closer than a second', () => {
    const named = rulerTicks({ fromMs: 0, untilMs: 500 }, 500).flatMap(({ text }) => text ?? []);
    expect(named[1]).toBe('0:00.100');
  });
});
