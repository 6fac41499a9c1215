import assert from 'node:assert/strict';
import { test } from 'node:test';

import { inRoot, readJson } from '../repository.mjs';
import { checkProse } from './check-prose.mjs';
import { PLACES } from './files.mjs';

const rules = {
  terms: [
    { avoid: 'leave to join', write: 'invitation' },
    { avoid: 'grant(s)?', write: 'invitation$1', in: ['screens', 'docs'] },
  ],
  dictionary: ['muxer'],
};
const check = (path, source) => checkProse([{ path, source }], rules);

test('a finding has file, line, word, and what to write instead', async () => {
  const source = '# Title\n\nPhones need a\nleave to\njoin.\n';
  assert.deepEqual(await check('docs/a.md', source), [
    'docs/a.md:4 “leave to join”: write “invitation”.',
  ]);
});

test('misspelled words are found, words of the dictionary are not', async () => {
  const [finding, ...others] = await check('docs/a.md', 'A muxer has many inptus.');
  assert.match(finding, /^docs\/a\.md:1 “inptus” is not in the dictionary: write “inputs”/);
  assert.deepEqual(others, []);
});

test('code, addresses and names in Markdown are not prose', async () => {
  const source = '`grant` <https://x.test/inptus>\n\n```ts\nconst grant = inptus;\n```\n';
  assert.deepEqual(await check('docs/a.md', source), []);
});

test('comments of TypeScript are read, across their lines, but not their names', async () => {
  const source = [
    'const pattern = /[/\'"]/; // leave to join',
    '/**',
    ' * Has leave to',
    ' * join. @param inptus of `inptus`',
    ' */',
    "const path = '// leave to join';",
  ];
  const found = await check('packages/a/src/a.ts', source.join('\n'));
  assert.deepEqual(
    found.map((line) => line.split(' ')[0]),
    ['packages/a/src/a.ts:1', 'packages/a/src/a.ts:3', 'packages/a/src/a.ts:6'],
  );
});

test('texts of screens are read, keys and code are not', async () => {
  const source = [
    "const key = 'grant';",
    "const style = 'a { grant: b; }';",
    'const text = `The grant ${grant} ends now`;',
    "const row = { label: 'Grant' };",
  ];
  assert.deepEqual(await check('apps/frontend/src/a.ts', source.join('\n')), [
    'apps/frontend/src/a.ts:3 “grant”: write “invitation”.',
    'apps/frontend/src/a.ts:4 “Grant”: write “Invitation”.',
  ]);
});

test('a term counts only in the places that it names', async () => {
  assert.deepEqual(await check('apps/master/src/a.ts', '// One grant.'), []);
});

test('titles of tests are read, their examples are not', async () => {
  const source = "it('has leave to join', () => read('leave to join is this'));";
  assert.deepEqual(await check('packages/a/src/a.test.ts', source), [
    'packages/a/src/a.test.ts:1 “leave to join”: write “invitation”.',
  ]);
});

test('templates of Vue are read: texts, attributes and expressions', async () => {
  const source = [
    '<script setup lang="ts">',
    "const text = 'the grant ends now';",
    '</script>',
    '<template>',
    '  <p class="grant" :class="{ grant }" title="A grant">The {{ grant }} is a grant.</p>',
    '  <b>{{ grant ? `no grant is left` : grant }}</b>',
    '</template>',
  ];
  const found = await check('apps/frontend/src/A.vue', source.join('\n'));
  assert.deepEqual(
    found.map((line) => line.split(' ')[0].split(':')[1]),
    ['2', '5', '5', '6'],
  );
});

test('the glossary may name the words that are not used', async () => {
  assert.deepEqual(await check('docs/glossary.md', 'Not a grant.'), []);
});

test('terms of the word list name places that exist', () => {
  for (const { avoid, in: places = [] } of readJson(inRoot('docs/terms.json'))) {
    for (const place of places) assert.ok(PLACES.includes(place), `${avoid}: ${place}`);
  }
});
