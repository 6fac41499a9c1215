import { SessionState, type Session } from '@ubii/proto';
import { expect, it } from 'vitest';
import { afterRestart } from './restart-words.ts';

const { SESSION_RUNNING, SESSION_STOPPED } = SessionState;
const session = (
  name: string,
  { state = SESSION_RUNNING as SessionState, startWithMaster = true } = {},
): Session => ({ name, extension: { state, startWithMaster, problems: [] } }) as unknown as Session;
const stopped = { state: SESSION_STOPPED };
const ofPage = { startWithMaster: false };

it('names the sessions that the master started again after a restart, and those that do not run', () => {
  expect(afterRestart(['Hands'], [session('Hands')])).toBe('The master started “Hands” again.');
  expect(afterRestart(['Hands', 'Mirror'], [session('Mirror'), session('Hands')])).toBe(
    'The master started “Hands” and “Mirror” again.',
  );
  expect(afterRestart(['Hands', 'Mirror'], [session('Mirror'), session('Hands', stopped)])).toBe(
    'The master started “Mirror” again. “Hands” does not run.',
  );
  expect(afterRestart(['a', 'b', 'c'], [])).toBe('3 sessions do not run.');
  expect(afterRestart([], [session('New')])).toBe('');
});

it('tells sessions that their pages started again from those that the master did, which the terminal counts', () => {
  const now = [session('a'), session('Seeing', ofPage), session('b')];
  expect(afterRestart(['Seeing', 'a', 'b'], now)).toBe(
    'The master started “a” and “b” again. An open page started “Seeing” again.',
  );
  const many = [session('x', ofPage), session('y', ofPage), session('z', ofPage)];
  expect(afterRestart(['x', 'y', 'z'], many)).toBe('Open pages started 3 sessions again.');
});

it('counts sessions of the same name', () => {
  expect(afterRestart(['Wave', 'Wave'], [session('Wave')])).toBe(
    'The master started “Wave” again. “Wave” does not run.',
  );
  expect(afterRestart(['Wave', 'Wave'], [session('Wave'), session('Wave', ofPage)])).toBe(
    'The master started “Wave” again. An open page started “Wave” again.',
  );
});
