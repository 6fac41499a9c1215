import { expect, it } from 'vitest';

import { RecordingLog } from '../../testing/index.ts';
import { clockSuite } from '../../testing/acceptance/index.ts';
import { SystemClock } from './system-clock.ts';

clockSuite('SystemClock', () => ({
  clock: new SystemClock(new RecordingLog()),
  passTime: () => {},
}));

it('a task that fails is logged and stops no other', async () => {
  const log = new RecordingLog();
  const clock = new SystemClock(log);
  await new Promise<void>((resolve) => {
    clock.atEndOfTurn(() => {
      throw new Error('first fails');
    });
    clock.atEndOfTurn(resolve);
  });
  expect(log.lines).toMatchObject([{ level: 'error', fields: { reason: 'Error: first fails' } }]);
});
