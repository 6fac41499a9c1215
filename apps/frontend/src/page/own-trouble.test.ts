import { StatusProblemSeverity, type StatusProblem } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { ownTroubles } from './own-trouble.ts';

const problem = (changes: Partial<StatusProblem>): StatusProblem => ({
  code: 'publisher_noisy',
  severity: StatusProblemSeverity.WARNING,
  text: 'Mara publishes 900 records per second.',
  clientId: 'me',
  sinceMs: 5,
  remedy: 'Let it publish less often.',
  sessionId: '',
  moduleId: '',
  ...changes,
});
const mine = (problems: StatusProblem[], openSession?: string) =>
  ownTroubles(problems, { id: 'me', name: 'Mara' }, openSession);

describe('ownTroubles', () => {
  it('says to the person what their page does, and what they can do', () => {
    expect(mine([problem({})])).toMatchObject([
      {
        text: 'This page publishes 900 records per second.',
        remedy: expect.stringMatching(/^Publish fewer/),
      },
    ]);
  });

  it('is silent about others', () => {
    expect(mine([problem({ clientId: 'you' }), problem({ clientId: '' })])).toEqual([]);
    expect(ownTroubles([problem({ clientId: '' })], { id: '', name: 'x' }, undefined)).toEqual([]);
  });

  it('warns clients that run slow modules, and clients that have their session open', () => {
    const slow = problem({ code: 'module_slow', clientId: 'node', sessionId: 's', moduleId: 'm' });
    expect(mine([slow])).toEqual([]);
    expect(mine([slow], 's')).toMatchObject([{ sessionId: 's', remedy: slow.remedy }]);
    expect(mine([{ ...slow, clientId: 'me' }])).toHaveLength(1);
  });

  it('a problem stays the same one while its numbers change', () => {
    const [a] = mine([problem({})]);
    const [b] = mine([problem({ text: 'Mara publishes 800 records per second.', sinceMs: 9 })]);
    expect(a?.key).toBe(b?.key);
  });
});
