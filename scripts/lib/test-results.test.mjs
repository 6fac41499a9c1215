import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';

import { addCounts, readCounts, reportFile, summary } from './test-results.mjs';

function counts(report, exitCode) {
  const file = reportFile('test-of-the-scripts');
  if (report !== undefined) writeFileSync(file, JSON.stringify(report));
  return readCounts(file, exitCode);
}

test('counts are read from the reports of Vitest and of Playwright', () => {
  assert.deepEqual(counts({ numPassedTests: 3, numFailedTests: 0 }, 0), { passed: 3, failed: 0 });
  const stats = { expected: 4, flaky: 1, unexpected: 2, skipped: 9 };
  assert.deepEqual(counts({ stats }, 1), { passed: 5, failed: 2 });
});

test('a run that ends badly without naming a test is a failure', () => {
  assert.deepEqual(counts({ numPassedTests: 3, numFailedTests: 0 }, 1), { passed: 3, failed: 1 });
  assert.deepEqual(counts(undefined, 1), { passed: 0, failed: 1 });
});

test('counts add up', () => {
  const all = [
    { passed: 1, failed: 0 },
    { passed: 2, failed: 3 },
  ];
  assert.deepEqual(addCounts(all), { passed: 3, failed: 3 });
});

test('the last line has the counts, and what failed stands before it', () => {
  const tests = [{ name: 'bad', isFlaky: false, message: 'no' }];
  assert.equal(
    summary([
      { passed: 1, failed: 1, tests },
      { passed: 2, failed: 0 },
    ]),
    '\nfailed: bad\n    no\n\n3 passed, 1 failed\n',
  );
});
