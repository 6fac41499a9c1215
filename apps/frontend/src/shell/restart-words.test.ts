import { SessionState, type Session } from '@ubii/proto';
import { expect, it } from 'vitest';
import { afterRestart } from './restart-words.ts';

const { SESSION_RUNNING, SESSION_STOPPED } = SessionState;
const session = (name: string, state: SessionState = SESSION_RUNNING): Session =>
  ({ name, extension: { state, problems: [] } }) as unknown as Session;

it('names the sessions that run again after a restart, and those that do not', () => {
  expect(afterRestart(['Hands'], [session('Hands')])).toBe('“Hands” runs again.');
  expect(afterRestart(['Hands', 'Mirror'], [session('Mirror'), session('Hands')])).toBe(
    '“Hands” and “Mirror” run again.',
  );
  expect(
    afterRestart(['Hands', 'Mirror'], [session('Mirror'), session('Hands', SESSION_STOPPED)]),
  ).toBe('“Mirror” runs again. “Hands” does not run.');
  expect(afterRestart(['a', 'b', 'c'], [])).toBe('3 sessions do not run.');
  expect(afterRestart([], [session('New')])).toBe('');
});

it('counts sessions of the same name', () => {
  expect(afterRestart(['Wave', 'Wave'], [session('Wave')])).toBe(
    '“Wave” runs again. “Wave” does not run.',
  );
});
