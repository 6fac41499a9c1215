import { fromJson, SessionState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { aSession } from '../testing/a-session.ts';
import { filterRows, sessionRow, withStored } from './session-rows.ts';

const { SESSION_RUNNING, SESSION_STOPPED } = SessionState;
const running = aSession({ id: 'r', name: 'Zebra', state: SESSION_RUNNING });
const stopped = aSession({ id: 's', name: 'Ant', state: SESSION_STOPPED });
const broken = aSession({
  id: 'b',
  name: 'Bee',
  json: {
    extension: {
      problems: [{ message: 'Careful.' }, { isError: true, message: 'It cannot.' }],
    },
  },
});

describe('the list of sessions', () => {
  const rows = [stopped, broken, running].map((one) => sessionRow(one, undefined));
  const names = (search: string, filter: 'all' | 'running' | 'stopped' | 'problems') =>
    filterRows(rows, search, filter).map(({ session }) => session.name);

  it('has those that run first, then by name', () => {
    expect(names('', 'all')).toEqual(['Zebra', 'Ant', 'Bee']);
  });

  it('is searched by words in names, tags and modules', () => {
    expect(names('bee MIRROR', 'all')).toEqual(['Bee']);
    expect(names('nothing', 'all')).toEqual([]);
  });

  it('is filtered by what runs and what has problems', () => {
    expect(names('', 'running')).toEqual(['Zebra']);
    expect(names('', 'stopped')).toEqual(['Ant', 'Bee']);
    expect(names('', 'problems')).toEqual(['Bee']);
  });

  it('says the error before the warning', () => {
    expect(rows[1]).toMatchObject({ problem: 'It cannot.', errors: 1, warnings: 1 });
  });

  it('shows statistics of those that run only', () => {
    const statistics = fromJson('ubii.extension.SessionStatistics', { modules: [{ errors: 1 }] });
    expect(sessionRow(running, statistics).totals?.errors).toBe(1);
    expect(sessionRow(stopped, statistics).totals).toBeUndefined();
  });

  it('holds stored ones that are not open, each once [SE-27]', () => {
    const stored = [
      aSession({ id: 'x', name: 'Other' }),
      aSession({ id: 's', name: 'Ant' }),
      aSession({ id: 'y', name: 'Kept' }),
    ];
    const kept = aSession({ id: 'k', name: 'Kept', json: { extension: { stored: true } } });
    expect(withStored([stopped, kept], stored).map(({ id, name }) => [id, name])).toEqual([
      ['s', 'Ant'],
      ['k', 'Kept'],
      ['x', 'Other'],
    ]);
  });
});
