import { describe, expect, it } from 'vitest';

import { SeatOffers } from './phone-requests.ts';

/** Bytes from 0 on: the first code is of the first letters. */
function counting(): () => number {
  let next = 0;
  return () => next++ % 256;
}

describe('codes for a seat', () => {
  it('are of letters that are not taken for each other, and are typed in any way', () => {
    const offers = new SeatOffers(counting());
    expect(offers.offer('mara', 0)).toBe('ABCDEF');
    expect(offers.take(' abc-def ', 1000)).toBe('mara');
  });

  it('are good once, for two minutes, and until the next one for the seat', () => {
    const offers = new SeatOffers(counting());
    const first = offers.offer('mara', 0);
    const second = offers.offer('mara', 0);
    expect(offers.take(first, 0)).toBeUndefined();
    expect(offers.take(second, 120_000)).toBeUndefined();
    const third = offers.offer('mara', 0);
    expect(offers.take(third, 119_999)).toBe('mara');
    expect(offers.take(third, 119_999)).toBeUndefined();
  });

  it('are drawn without bytes that would make some letters likelier', () => {
    const bytes = [255, 254, 248, 3, 3, 3, 3, 3, 3];
    expect(new SeatOffers(() => bytes.shift()!).offer('mara', 0)).toBe('DDDDDD');
  });
});
