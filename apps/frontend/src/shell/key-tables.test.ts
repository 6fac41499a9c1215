import { expect, it } from 'vitest';
import { CANVAS_LETTERS } from '../graph/canvas/canvas-letters.ts';
import { GRAPH_KEYS, keyGroups } from './key-tables.ts';
import { shortcutsOn } from './shortcuts.ts';

it('lists every letter of the canvas, and no single key has two meanings on the page of a graph', () => {
  const own = GRAPH_KEYS.map(({ keys }) => keys).filter((keys) => /^[A-Z]$/.test(keys));
  expect([...own].sort().join('')).toBe(CANVAS_LETTERS);
  const single = shortcutsOn({ ownKeys: CANVAS_LETTERS }).map(({ keys }) => keys);
  expect(single.filter((keys) => own.includes(keys))).toEqual([]);
});

it.each([
  ['/', 'On Home'],
  ['/sessions', 'On a row of Sessions, Modules or Clients'],
  ['/sessions/3f1d', 'In the graph of a session'],
  ['/sessions/3f1d/log', 'In the graph of a session'],
  ['/panels', 'On Panels'],
  ['/recordings/walk', 'In a recording'],
  ['/topics', 'Everywhere'],
])('shows the keys of the page %s first', (path, first) => {
  const groups = keyGroups(path, []).map(({ title }) => title);
  expect(groups[0]).toBe(first);
  expect(new Set(groups).size).toBe(6);
});
