import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';

import { formatFailedTests, readFailedTests } from './failed-tests.mjs';
import { reportFile } from './test-results.mjs';

function failedIn(report) {
  const file = reportFile('test-of-the-failures');
  if (report !== undefined) writeFileSync(file, JSON.stringify(report));
  return readFailedTests(file);
}

test('failed and flaky tests are found in what Playwright reports', () => {
  const spec = (title, status, ...messages) => ({
    title,
    file: 'home.spec.ts',
    line: 3,
    tests: [
      {
        status,
        results: messages.map((message) => ({ errors: message === '' ? [] : [{ message }] })),
      },
    ],
  });
  const suites = [
    {
      specs: [spec('fine', 'expected', '')],
      suites: [{ specs: [spec('bad', 'unexpected', 'no'), spec('odd', 'flaky', 'hm', '')] }],
    },
  ];
  assert.deepEqual(failedIn({ suites }), [
    { name: 'home.spec.ts:3 bad', isFlaky: false, message: 'no' },
    { name: 'home.spec.ts:3 odd', isFlaky: true, message: 'hm' },
  ]);
});

test('failed tests and files that do not load are found in what Vitest reports', () => {
  const testResults = [
    {
      name: 'a.test.ts',
      message: '',
      assertionResults: [
        { status: 'passed', fullName: 'fine', failureMessages: [] },
        { status: 'failed', fullName: 'bad', failureMessages: ['no'] },
      ],
    },
    { name: 'b.test.ts', message: 'SyntaxError', assertionResults: [] },
  ];
  assert.deepEqual(failedIn({ testResults }), [
    { name: 'a.test.ts bad', isFlaky: false, message: 'no' },
    { name: 'b.test.ts', isFlaky: false, message: 'SyntaxError' },
  ]);
});

test('without a report nothing is said', () => {
  assert.deepEqual(failedIn(undefined), []);
  assert.equal(formatFailedTests([]), '');
});

test('a text names each test and keeps its message short', () => {
  const message = Array.from({ length: 99 }, (_, index) => `line ${index}`).join('\n');
  const text = formatFailedTests([{ name: 'x', isFlaky: true, message }]);
  assert.match(text, /flaky, passed when it was run again: x\n {4}line 0\n/);
  assert.doesNotMatch(text, /line 30/);
});
