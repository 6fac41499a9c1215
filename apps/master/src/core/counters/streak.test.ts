import { describe, expect, it } from 'vitest';
import { Streak } from './streak.ts';

describe('Streak', () => {
  it('stands for 30 s after the last mishap, and begins again after that [EX-18]', () => {
    const streak = new Streak();
    expect(streak.isOn(0)).toBe(false);
    expect(streak.add(1_000)).toBe(true);
    expect(streak.add(20_000)).toBe(false);
    expect(streak.isOn(50_000)).toBe(true);
    expect(streak.sinceMs).toBe(1_000);
    expect(streak.isOn(50_001)).toBe(false);
    expect(streak.add(60_000)).toBe(true);
    expect(streak).toMatchObject({ count: 3, sinceMs: 60_000 });
  });
});
