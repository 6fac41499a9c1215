import { expect, it } from 'vitest';

import { SendTimes } from './send-times.ts';

it('gives later times to what is sent later, also when the clock was set back [EX-51]', () => {
  let nowMs = 5_000;
  const times = new SendTimes({ nowMs: () => nowMs });
  const first = times.next();
  const second = times.next();
  nowMs = 1_000;
  const third = times.next();
  nowMs = 9_000;
  expect([first, second, third, times.next()]).toEqual([5_000, 5_001, 5_002, 9_000]);
});
