import { expect, it } from 'vitest';
import { colorOf, looksOf } from './series-look.ts';

it('neighbouring lines of a plot differ in lightness and in pattern', () => {
  const looks = looksOf(Array.from({ length: 12 }, () => 'number' as const));
  for (const [i, look] of looks.entries()) {
    const next = looks[i + 1];
    if (!next) continue;
    expect(colorOf(next)).not.toBe(colorOf(look));
    expect(next.dash).not.toEqual(look.dash);
  }
  expect(new Set(looks.map((look) => JSON.stringify(look))).size).toBe(12);
});
