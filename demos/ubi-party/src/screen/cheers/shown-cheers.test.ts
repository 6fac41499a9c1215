import { expect, test } from 'vitest';
import type { Cheer } from '../../sim/index.ts';
import { addCheer, stillShown, type ShownCheer } from './shown-cheers.ts';

const cheer = (key: string, kind: Cheer['kind'] = 'nice'): Cheer => ({ key, kind, name: key });

function shownAfter(...keys: string[]): readonly ShownCheer[] {
  return keys.reduce<readonly ShownCheer[]>(
    (shown, key, id) => addCheer(shown, cheer(key), id, 1000),
    [],
  );
}

test('each person has one cheer, the newest first', () => {
  const shown = addCheer(shownAfter('a', 'b'), cheer('a', 'love'), 9, 1000);
  expect(shown.map(({ key, kind }) => [key, kind])).toEqual([
    ['a', 'love'],
    ['b', 'nice'],
  ]);
});

test('three fit, the oldest goes', () => {
  expect(shownAfter(...'abcdefgh').map(({ key }) => key)).toEqual([...'hgf']);
});

test('cheers go after a while', () => {
  const shown = addCheer(shownAfter('a'), cheer('b'), 5, 2000);
  expect(stillShown(shown, 3499).map(({ key }) => key)).toEqual(['b', 'a']);
  expect(stillShown(shown, 3500).map(({ key }) => key)).toEqual(['b']);
  expect(stillShown(shown, 4500)).toEqual([]);
});
