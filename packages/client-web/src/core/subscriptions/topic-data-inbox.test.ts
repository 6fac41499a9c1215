import { describe, expect, it } from 'vitest';
import { ClassicDuplicates } from './topic-data-inbox.ts';

const frame = (...bytes: number[]) => new Uint8Array(bytes);

describe('ClassicDuplicates', () => {
  it('leaves one of as many copies as there are subscriptions', () => {
    const duplicates = new ClassicDuplicates();
    expect([1, 2, 3].map(() => duplicates.isCopy(frame(1, 2), 3))).toEqual([false, true, true]);
  });

  it('takes the same value published again for what it is', () => {
    const duplicates = new ClassicDuplicates();
    expect([1, 2, 3, 4].map(() => duplicates.isCopy(frame(1), 2))).toEqual([
      false,
      true,
      false,
      true,
    ]);
    expect(duplicates.isCopy(frame(9), 1)).toBe(false);
    expect(duplicates.isCopy(frame(9), 1)).toBe(false);
  });

  it('starts again with another frame', () => {
    const duplicates = new ClassicDuplicates();
    expect(duplicates.isCopy(frame(1), 2)).toBe(false);
    expect(duplicates.isCopy(frame(2), 2)).toBe(false);
    expect(duplicates.isCopy(frame(2), 2)).toBe(true);
    expect(duplicates.isCopy(frame(2, 2), 1)).toBe(false);
  });
});
