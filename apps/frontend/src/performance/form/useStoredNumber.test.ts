// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { useStoredNumber } from './useStoredNumber.ts';

describe('a stored number', () => {
  beforeEach(() => localStorage.clear());
  const stored = () => useStoredNumber('rate', { initial: 100, min: 1, max: 1000 });

  it('begins with what it should', () => expect(stored().value).toBe(100));

  it.each(['many', '', '5000'])('begins so after a text that was kept before: "%s"', (text) => {
    localStorage.setItem('ubii.performance.rate', text);
    expect(stored().value).toBe(100);
  });

  it('is what was last typed, and nothing while the text in its field is refused', () => {
    const number = stored();
    number.field['onUpdate:modelValue'](7);
    expect(number.value).toBe(7);
    number.field.onRefuse('Enter a number.');
    expect([number.value, number.error]).toEqual([undefined, 'Enter a number.']);
    number.field.onRefuse(undefined);
    expect(number.value).toBe(7);
  });
});
