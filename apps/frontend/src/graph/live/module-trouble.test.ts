import { fromJson, ModuleEventKind, type ModuleEvent } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { moduleTrouble } from './module-trouble.ts';

const event = (timeMs: number, kind: ModuleEventKind): ModuleEvent => ({
  ...fromJson('ubii.extension.ModuleEvent', { moduleId: 'module', message: 'broken', line: 7 }),
  timeMs,
  kind,
});

describe('moduleTrouble', () => {
  it('is none where nothing is wrong, or only with another module', () => {
    const problems = [{ moduleId: 'other', message: 'x' }];
    const session = aSession({ json: { extension: { problems } } });
    expect(moduleTrouble(session, [event(1, ModuleEventKind.LOG)], 'module', 2)).toEqual({
      count: 0,
      failure: undefined,
      event: undefined,
    });
  });

  it('is the first cause, also when an output is refused', () => {
    const first = { ...event(1000, ModuleEventKind.REFUSED), message: 'Output "a": first' };
    const next = { ...event(1500, ModuleEventKind.ERROR), message: 'and then' };
    expect(moduleTrouble(aSession(), [first, next], 'module', 2000)).toMatchObject({
      count: 1,
      failure: { message: 'Output "a": first' },
    });
  });

  it('is an error of the last seconds, and what the session says', () => {
    const failed = event(1000, ModuleEventKind.ERROR);
    expect(moduleTrouble(aSession(), [failed], 'module', 2000)).toMatchObject({
      count: 1,
      failure: { message: 'broken' },
    });
    expect(moduleTrouble(aSession(), [failed], 'module', 60_000).failure).toBeUndefined();
    const problems = [{ moduleId: 'module', message: 'given up', isError: true }];
    const session = aSession({ json: { extension: { problems } } });
    expect(moduleTrouble(session, [failed], 'module', 2000)).toMatchObject({
      count: 1,
      failure: { message: 'given up' },
    });
  });

  it('is told in the words of the event where the session names a failed run', () => {
    const failed = event(1000, ModuleEventKind.ERROR);
    const problems = [
      { moduleId: 'module', code: 'module_run_failed', message: 'A run failed', isError: true },
    ];
    const session = aSession({ json: { extension: { problems } } });
    expect(moduleTrouble(session, [failed], 'module', 60_000)).toMatchObject({
      count: 1,
      failure: { message: 'broken' },
      event: { line: 7 },
    });
    expect(moduleTrouble(session, [], 'module', 2000)).toMatchObject({
      count: 1,
      failure: { message: 'A run failed' },
    });
  });
});
