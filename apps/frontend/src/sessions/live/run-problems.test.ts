import { fromJson } from '@ubii/proto';
import { expect, it } from 'vitest';
import { aSession } from '../testing/a-session.ts';
import { runProblems } from './run-problems.ts';

const event = {
  ...fromJson('ubii.extension.ModuleEvent', {
    kind: 'REFUSED',
    moduleId: 'module',
    message: 'Output "a": write { double: value }, not a bare number.',
    suppressed: 4,
  }),
  timeMs: 1000,
};

it('problems of runs are those of now, once, and none beside an error of the session', () => {
  const session = aSession();
  const { id = '', name } = session.processingModules[0]!;
  const events = [{ ...event, moduleId: id }];
  expect(runProblems(session, events, 2000)).toMatchObject([
    { isError: true, moduleId: id, moduleName: name, message: event.message, count: 5 },
  ]);
  expect(runProblems(session, events, 60_000)).toEqual([]);
  const problems = [{ moduleId: id, message: 'ended', isError: true }];
  const failed = aSession({ json: { extension: { problems } } });
  expect(runProblems(failed, events, 2000)).toEqual([]);
});
