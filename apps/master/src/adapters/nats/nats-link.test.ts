import { expect, it } from 'vitest';

import { ReconnectPace } from './nats-link.ts';

it('[CU-60] waits longer after each attempt, up to 2 s, and begins again after a success', () => {
  const pace = new ReconnectPace(() => 1);
  const delays = Array.from({ length: 9 }, () => {
    const delayMs = pace.delayMs();
    pace.handleAttempt();
    return delayMs;
  });
  expect(delays).toEqual([50, 100, 200, 400, 800, 1600, 2000, 2000, 2000]);
  pace.handleSuccess();
  expect(pace.delayMs()).toBe(50);
});

it('[CU-60] does not let all masters try at once', () => {
  const soon = new ReconnectPace(() => 0);
  const late = new ReconnectPace(() => 0.5);
  expect([soon.delayMs(), late.delayMs()]).toEqual([25, 38]);
});
