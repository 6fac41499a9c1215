import { preciseClockSuite } from '@ubii/timing/testing';
import { expect, it } from 'vitest';

import { RecordingLog } from '../../testing/index.ts';
import { PreciseSystemClock } from './precise-system-clock.ts';

preciseClockSuite('PreciseSystemClock', () => ({
  clock: new PreciseSystemClock(new RecordingLog()),
  passTime: () => undefined,
}));

it('a turn ends after what was promised in it', async () => {
  const clock = new PreciseSystemClock(new RecordingLog());
  const order: string[] = [];
  await new Promise<void>((resolve) => {
    clock.atEndOfTurn(() => {
      order.push('end');
      resolve();
    });
    void Promise.resolve().then(() => order.push('promised'));
  });
  expect(order).toEqual(['promised', 'end']);
});

it('a task that fails is logged and stops no other', async () => {
  const log = new RecordingLog();
  const clock = new PreciseSystemClock(log);
  await new Promise<void>((resolve) => {
    clock.atEndOfTurn(() => {
      throw new Error('first fails');
    });
    clock.atEndOfTurn(resolve);
  });
  expect(log.lines).toMatchObject([{ level: 'error', fields: { reason: 'Error: first fails' } }]);
});
