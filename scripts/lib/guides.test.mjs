import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';

import { readGuides } from './follow-guides.mjs';
import { applyHunks, contentAfter, filesOf, readGuide } from './guides.mjs';
import { inRoot } from './repository.mjs';

const fence = '```';
const block = (language, content) => `${fence}${language}\n${content}\n${fence}\n`;
const change = (diff) => readGuide(`Change \`a.ts\`:\n\n${block('diff', diff)}`)[0].hunks;

test('a guide creates files, changes files and runs commands', () => {
  const text = [
    `Create \`a.ts\`:\n\n${block('ts', 'export const a = 1;')}`,
    `Change \`b.ts\`:\n\n${block('diff', ' one\n+two\n@@\n-three')}`,
    block('sh', 'npm start\nnpm test'),
    block('text', '1 passed'),
  ].join('\n');
  const steps = readGuide(text);
  assert.deepEqual(
    steps.map(({ kind }) => kind),
    ['create', 'change', 'run'],
  );
  assert.equal(steps[0].content, 'export const a = 1;\n');
  assert.equal(steps[1].hunks.length, 2);
  assert.deepEqual(steps[2].commands, ['npm start', 'npm test']);
  assert.deepEqual(filesOf(steps), ['a.ts', 'b.ts']);
});

test('a block of code that names no file is an error', () => {
  assert.throws(() => readGuide(block('ts', 'const a = 1;')), /names no file: const a = 1;/);
});

test('a block with a longer fence may hold blocks', () => {
  const text = `Create \`a.md\`:\n\n${fence}\`md\n${block('json', '{}')}${fence}\`\n`;
  assert.equal(readGuide(text)[0].content, block('json', '{}'));
});

test('a change adds and removes lines, in each of its places', () => {
  const hunks = change(' one\n+one and a half\n@@\n-three\n+3');
  assert.equal(applyHunks('one\ntwo\nthree\n', hunks, 'a.ts'), 'one\none and a half\ntwo\n3\n');
});

test('a line that ends with … stands for the whole line', () => {
  assert.equal(applyHunks('| a | b |\n', change(' | a …\n+| c |'), 'a.ts'), '| a | b |\n| c |\n');
});

test('a change that fits no place, or two, is an error', () => {
  assert.throws(() => applyHunks('two\n', change(' one\n+1'), 'a.ts'), /0 places/);
  assert.throws(() => applyHunks('one\none\n', change(' one\n+1'), 'a.ts'), /2 places/);
  assert.throws(() => applyHunks('one\n', change('+1'), 'a.ts'), /0 places/);
});

test('a file is created only where there is none, and changed only where there is one', () => {
  const [created] = readGuide(`Create \`a.ts\`:\n\n${block('ts', 'a;')}`);
  assert.equal(contentAfter(created, undefined), 'a;\n');
  assert.throws(() => contentAfter(created, 'b;\n'), /a\.ts exists already/);
  const changed = { kind: 'change', path: 'a.ts', hunks: change('-b;\n+a;') };
  assert.equal(contentAfter(changed, 'b;\n'), 'a;\n');
  assert.throws(() => contentAfter(changed, undefined), /a\.ts does not exist/);
});

test('each guide is listed, and names its files at its end', () => {
  const list = readFileSync(inRoot('docs/guides/README.md'), 'utf8');
  for (const { name, steps } of readGuides()) {
    assert.ok(list.includes(`](${name})`), `${name} is not in docs/guides/README.md`);
    const [, end = ''] = readFileSync(inRoot('docs/guides', name), 'utf8').split('## Files');
    for (const path of filesOf(steps)) {
      const isNamed = end.includes(path) || end.includes(`\`${path.split('/').at(-1)}\``);
      assert.ok(isNamed, `${name} does not list ${path}`);
    }
  }
});
