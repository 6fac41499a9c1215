import assert from 'node:assert/strict';
import { test } from 'node:test';

import { findFolderCircles } from './folder-circles.mjs';

/** @param {Record<string, string[]>} imports by file */
function modules(imports) {
  return Object.entries(imports).map(([source, targets]) => ({
    source,
    dependencies: targets.map((resolved) => ({ resolved })),
  }));
}

test('folders that import each other in one direction have no circle', () => {
  const found = findFolderCircles(
    modules({
      'src/page/Page.vue': ['src/list/List.vue', 'src/model/thing.ts'],
      'src/list/List.vue': ['src/model/thing.ts'],
      'src/model/thing.ts': [],
    }),
    [],
  );
  assert.deepEqual(found, []);
});

test('a child does not hide its parent', () => {
  const found = findFolderCircles(
    modules({
      'src/editor/Editor.vue': ['src/library/useLibrary.ts'],
      'src/editor/draft/store.ts': [],
      'src/library/DraftRows.vue': ['src/editor/draft/store.ts'],
      'src/library/useLibrary.ts': [],
    }),
    [],
  );
  assert.equal(found.length, 1);
  assert.match(String(found[0]), /^In src these import each other in a circle: editor, library\./);
});

test('a circle of three folders is found', () => {
  const found = findFolderCircles(
    modules({
      'src/a/one.ts': ['src/b/two.ts'],
      'src/b/two.ts': ['src/c/three.ts'],
      'src/c/three.ts': ['src/a/other.ts'],
      'src/a/other.ts': [],
    }),
    [],
  );
  assert.match(String(found[0]), /^In src these import each other in a circle: a, b, c\./);
});

const PARENT = modules({
  'src/sim/sim.ts': ['src/sim/hill/hill.ts'],
  'src/sim/hill/hill.ts': ['src/sim/vector.ts'],
  'src/sim/vector.ts': [],
});

test('a folder whose own files import its child and are imported by it is a circle', () => {
  const [found] = findFolderCircles(PARENT, []);
  assert.match(
    String(found),
    /^In src\/sim these import each other in a circle: its own files, hill\./,
  );
});

test('such a folder can be known, a circle of folders in it cannot', () => {
  assert.deepEqual(findFolderCircles(PARENT, ['src/sim']), []);
  const planted = modules({
    'src/sim/sim.ts': ['src/sim/hill/hill.ts'],
    'src/sim/hill/hill.ts': ['src/sim/vector.ts', 'src/sim/race/race.ts'],
    'src/sim/race/race.ts': ['src/sim/hill/slope.ts'],
    'src/sim/hill/slope.ts': [],
    'src/sim/vector.ts': [],
  });
  const [found] = findFolderCircles(planted, ['src/sim']);
  assert.match(String(found), /^In src\/sim these import each other in a circle: hill, race\./);
});

test('a known folder without a circle must be deleted from the list', () => {
  assert.deepEqual(findFolderCircles([], ['src/sim']), [
    'src/sim has no circle: delete it from KNOWN_CIRCLES.',
  ]);
});
