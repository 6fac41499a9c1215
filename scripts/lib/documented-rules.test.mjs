import assert from 'node:assert/strict';
import test from 'node:test';

import { ruleProblems } from './documented-rules.mjs';

// Ids are put together here: the gate looks for them in this file as well.
const id = (number) => ['TD', number].join('-');
const spec = (text, path = 'docs/spec/topic-data.md') => ({ path, text });
const code = (text) => ({ path: 'packages/proto/src/a.ts', text });

test('a rule that is defined once may be quoted', () => {
  const files = [spec(`- **${id(1)}** A rule.`), code(`// [${id(1)}]`)];
  assert.deepEqual(ruleProblems(files), []);
});

test('a quoted rule that is not defined is reported once per file', () => {
  const files = [spec(`- **${id(1)}** A rule.`), code(`// ${id(2)}, ${id(2)}`)];
  assert.deepEqual(ruleProblems(files), [
    `packages/proto/src/a.ts quotes ${id(2)}, which docs/spec does not have.`,
  ]);
});

test('a rule that is defined twice is reported', () => {
  const files = [spec(`- **${id(1)}** A rule.`), spec(`- **${id(1)}** B.`, 'docs/spec/time.md')];
  assert.deepEqual(ruleProblems(files), [
    `docs/spec/time.md defines ${id(1)} again; docs/spec/topic-data.md has it.`,
  ]);
});

test('a guide may quote the rule that it adds', () => {
  const text = `+- **${id(2)}** A rule.\n\n// [${id(2)}]`;
  const guide = { path: 'docs/guides/a-service.md', text };
  assert.deepEqual(ruleProblems([spec(`- **${id(1)}** A rule.`), guide]), []);
});

test('each rule about existing clients needs a test that quotes it, unless it is excused', () => {
  const rule = ['EC', 1].join('-');
  const path = 'docs/spec/existing-clients.md';
  const page = spec(`- **${rule}** A rule.`, path);
  const tested = { path: 'a.test.ts', text: `it('does it [${rule}]')` };
  const excused = new Set([rule]);
  const quoted = code(`// [${rule}]`);
  assert.deepEqual(ruleProblems([page, quoted]), [`No test quotes ${rule} of ${path}.`]);
  assert.deepEqual(ruleProblems([page, tested]), []);
  assert.deepEqual(ruleProblems([page], excused), []);
  assert.equal(ruleProblems([page, tested], excused).length, 1);
});

test('words of other groups are no rules', () => {
  assert.deepEqual(ruleProblems([spec(`- **${id(1)}** A rule.`), code('UTF-8, RFC-9')]), []);
});
