import { expect, it } from 'vitest';
import { CANVAS_LETTERS } from '../graph/canvas/canvas-letters.ts';
import { GRAPH_KEYS } from './key-tables.ts';
import { shortcutsOn } from './shortcuts.ts';

it('lists every letter of the canvas, and no single key has two meanings on the page of a graph', () => {
  const own = GRAPH_KEYS.map(({ keys }) => keys).filter((keys) => /^[A-Z]$/.test(keys));
  expect([...own].sort().join('')).toBe(CANVAS_LETTERS);
  const single = shortcutsOn({ ownKeys: CANVAS_LETTERS }).map(({ keys }) => keys);
  expect(single.filter((keys) => own.includes(keys))).toEqual([]);
});
