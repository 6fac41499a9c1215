import { expect, it } from 'vitest';
import { pictureExpiryMs, storedHabits } from './picture-habits.ts';

it('lets pictures stand for a second, or three intervals where they come slowly [TD-49]', () => {
  expect([30, 10, 3, 2, 1, 0.5].map(pictureExpiryMs)).toEqual([1000, 1000, 1000, 1500, 3000, 6000]);
});

it('adapts and keeps nothing, unless the user said otherwise', () => {
  const first = { isAdaptive: true, keepsNewest: false };
  for (const text of ['', 'null', '[]', '{"keepsNewest":"yes","isAdaptive":0}']) {
    expect(storedHabits.read(text)).toEqual(first);
  }
  expect(storedHabits.read('{"keepsNewest":true,"isAdaptive":false}')).toEqual({
    isAdaptive: false,
    keepsNewest: true,
  });
});
