import { fromJson } from '@ubii/proto';
import { expect, it } from 'vitest';
import { isAlive, sessionAtRest, sessionLook } from './session-state.ts';

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
