import { SessionState } from '@ubii/proto';
import { expect, it } from 'vitest';
import type { RecentThing } from '../../page/recent.ts';
import { aSession } from '../../sessions/testing/a-session.ts';
import { continueEntries, whenOpened } from './continue-entries.ts';

const NOW_MS = new Date(2026, 4, 3, 15).getTime();
const thing = (id: string): RecentThing => ({ id, title: `${id} then`, path: '/x', atMs: NOW_MS });

it('leaves out sessions that run, that are gone, and what is no thing', () => {
  const sessions = [
    aSession({ id: 'a', name: 'Waves', state: SessionState.SESSION_STOPPED }),
    aSession({ id: 'b', state: SessionState.SESSION_RUNNING }),
  ];
  const things = ['session a', 'session b', 'session gone', 'page /topics', 'module clock'];
  const entries = continueEntries(things.map(thing), sessions, NOW_MS);
  expect(entries.map(({ title, fact }) => [title, fact])).toEqual([
    ['Waves', 'session, stopped'],
    ['module clock then', 'module'],
  ]);
});

it('has five entries, and none for what was only started from the palette', () => {
  const things = ['a', 'b', 'c', 'd', 'e', 'f'].map((name) => thing(`module ${name}`));
  expect(continueEntries(things, [], NOW_MS)).toHaveLength(5);
  expect(continueEntries([{ ...thing('module a'), path: '' }], [], NOW_MS)).toEqual([]);
});

it.each([
  [new Date(2026, 4, 3, 9, 5), 'today 09:05'],
  [new Date(2026, 4, 2, 23, 59), 'yesterday'],
  [new Date(2026, 4, 1, 12), '1 May 2026'],
])('%s is called %s', (at, words) => {
  expect(whenOpened(at.getTime(), NOW_MS)).toBe(words);
});
