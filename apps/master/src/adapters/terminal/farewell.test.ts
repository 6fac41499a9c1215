import { expect, it } from 'vitest';
import { formatFarewell } from './farewell.ts';

it.each([
  [0, 'Stopped.'],
  [1, 'Stopped. 1 session will start again with the master.'],
  [3, 'Stopped. 3 sessions will start again with the master.'],
])('%d sessions that start again: %s', (sessions, line) => {
  expect(formatFarewell(sessions)).toBe(line);
});
