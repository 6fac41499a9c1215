import { expect, it } from 'vitest';
import { clockSuite } from '../testing/index.ts';
import { SystemClock, systemClock } from './system-clock.ts';

clockSuite('systemClock', () => ({ clock: systemClock, passTime: () => undefined }));

clockSuite('SystemClock with turns of its own', () => ({
  clock: new SystemClock({ endTurn: (fn) => setImmediate(fn), handleError: () => undefined }),
  passTime: () => undefined,
}));

it('a callback that throws is handled and stops no other', async () => {
  const errors: unknown[] = [];
  const clock = new SystemClock({ handleError: (error) => errors.push(error) });
  const fail = (place: string) => (): void => {
    throw new Error(place);
  };
  clock.atEndOfTurn(fail('the end of a turn'));
  clock.after(0, fail('a timer'));
  const cancel = clock.every(1, fail('an interval'));
  while (errors.length < 4) await new Promise<void>((resolve) => clock.after(1, resolve));
  cancel();
  expect(errors).toEqual(
    expect.arrayContaining(
      ['the end of a turn', 'a timer', 'an interval'].map((place) => new Error(place)),
    ),
  );
});
