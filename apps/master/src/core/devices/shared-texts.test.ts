import { describe, expect, it } from 'vitest';
import { SharedTexts } from './shared-texts.ts';

describe('shared texts', () => {
  it('are equal to those they stand for', () => {
    const texts = new SharedTexts();
    for (const text of ['', 'motion', 'motion', 'x'.repeat(1_000)]) {
      expect(texts.share(text)).toBe(text);
    }
  });

  it('keep one list of equal ones, and tell different ones apart [CL-17]', () => {
    const texts = new SharedTexts();
    const first = texts.shareAll(['a', 'b']);
    expect(texts.shareAll(['a', 'b'])).toBe(first);
    expect(texts.shareAll(['a\nb'])).toEqual(['a\nb']);
    expect(texts.shareAll(['a', 'b', ''])).toEqual(['a', 'b', '']);
    expect(texts.shareAll([])).toEqual([]);
  });

  it('forget lists when there are too many [CL-17]', () => {
    const texts = new SharedTexts();
    const first = texts.shareAll(['a']);
    for (let i = 0; i < 5_000; i++) texts.shareAll([String(i)]);
    expect(texts.shareAll(['a'])).toEqual(first);
  });
});
