import { describe, expect, it } from 'vitest';
import { fuzzyScore } from './fuzzy.ts';

describe('fuzzyScore', () => {
  it('finds words as they stand, and letters in order', () => {
    expect(fuzzyScore('accel', '/mara/smart-device/acceleration')).toBeDefined();
    expect(fuzzyScore('sda', '/mara/smart-device/acceleration')).toBeDefined();
    expect(fuzzyScore('mara accel', '/mara/smart-device/acceleration')).toBeDefined();
  });

  it('refuses what is not there', () => {
    expect(fuzzyScore('theo accel', '/mara/smart-device/acceleration')).toBeUndefined();
    expect(fuzzyScore('zzz', 'Settings')).toBeUndefined();
  });

  it('prefers whole words, beginnings and short texts', () => {
    const score = (text: string) => fuzzyScore('top', text)!;
    expect(score('Topics')).toBeGreaterThan(score('Stop'));
    expect(score('Topics')).toBeGreaterThan(score('Topics of the whole wide world'));
    expect(score('Stop')).toBeGreaterThan(score('The other page'));
  });
});
