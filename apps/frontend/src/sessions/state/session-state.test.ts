import { fromJson } from '@ubii/proto';
import { expect, it } from 'vitest';
import { isAlive, lookNow, sessionAtRest, sessionLook } from './session-state.ts';

it('a session that the master does not have any more does not run, and has no problems', () => {
  const running = fromJson('ubii.sessions.Session', {
    name: 'Mirror',
    status: 'RUNNING',
    extension: { state: 'SESSION_DEGRADED', revision: 3, problems: [{ message: 'late' }] },
  });
  const rest = sessionAtRest(running);
  expect(isAlive(running)).toBe(true);
  expect(isAlive(rest)).toBe(false);
  expect(sessionLook(rest).word).toBe('Not started');
  expect(rest).toMatchObject({ name: 'Mirror', extension: { revision: 3, problems: [] } });
});

it('nothing is shown as running while the master cannot be asked', () => {
  const running = fromJson('ubii.sessions.Session', { name: 'Mirror', status: 'RUNNING' });
  expect(lookNow(running, true)).toMatchObject({ mark: 'live', word: 'Running' });
  expect(lookNow(running, false)).toMatchObject({
    mark: 'away',
    word: 'Not connected to the master',
  });
});
