import { describe, expect, it } from 'vitest';
import { isLongerThan } from './text-length.ts';

describe('isLongerThan', () => {
  it.each(['a', 'é', '€', '🙂', 'aé€🙂'])('counts the bytes of %j in UTF-8', (text) => {
    const { byteLength } = new TextEncoder().encode(text);
    expect(isLongerThan(text, byteLength)).toBe(false);
    expect(isLongerThan(text, byteLength - 1)).toBe(true);
  });
});
