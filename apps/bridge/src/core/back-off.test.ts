import { expect, it } from 'vitest';
import { BackOff } from './back-off.ts';

it('pauses longer after each attempt, up to half a minute [BR-40]', () => {
  const backOff = new BackOff(() => 0.5);
  const pauses = Array.from({ length: 8 }, () => backOff.nextMs());
  expect(pauses).toEqual([500, 1_000, 2_000, 4_000, 8_000, 16_000, 30_000, 30_000]);
  backOff.handleConnected();
  expect(backOff.nextMs()).toBe(500);
});
