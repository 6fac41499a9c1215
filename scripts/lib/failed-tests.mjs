import { existsSync } from 'node:fs';
import { stripVTControlCharacters } from 'node:util';

import { readJson } from './repository.mjs';

/** @typedef {{ name: string, isFlaky: boolean, message: string }} FailedTest */

/** Maximum lines of a failure message; the full one is in the log of the run. */
const MAX_LINES = 25;

/**
 * The tests that failed in a report of Vitest or Playwright, also those that passed when they were
 * run again.
 *
 * @param {string} file
 * @returns {FailedTest[]}
 */
export function readFailedTests(file) {
  if (!existsSync(file)) return [];
  const { suites, testResults } = readJson(file);
  return suites ? ofPlaywright(suites) : ofVitest(testResults ?? []);
}

/** @param {readonly FailedTest[]} tests @returns {string} a text for the end of a run; empty when there are none */
export function formatFailedTests(tests) {
  return tests
    .map(({ name, isFlaky, message }) => {
      const lines = stripVTControlCharacters(message).trimEnd().split('\n').slice(0, MAX_LINES);
      const verdict = isFlaky ? 'flaky, passed when it was run again' : 'failed';
      return `\n${verdict}: ${name}\n${lines.map((line) => `    ${line}\n`).join('')}`;
    })
    .join('');
}

function ofPlaywright(suites) {
  return suites.flatMap((suite) => [
    ...(suite.specs ?? []).flatMap((spec) =>
      spec.tests
        .filter(({ status }) => status === 'unexpected' || status === 'flaky')
        .map(({ status, results }) => ({
          name: `${spec.file}:${spec.line} ${spec.title}`,
          isFlaky: status === 'flaky',
          message: results.find(({ errors }) => errors.length > 0)?.errors[0].message ?? '',
        })),
    ),
    ...ofPlaywright(suite.suites ?? []),
  ]);
}

function ofVitest(files) {
  return files.flatMap(({ name, message, assertionResults }) => {
    const failed = assertionResults
      .filter(({ status }) => status === 'failed')
      .map(({ fullName, failureMessages }) => ({
        name: `${name} ${fullName}`,
        isFlaky: false,
        message: failureMessages.join('\n'),
      }));
    // A file that does not load has no tests.
    return failed.length === 0 && message ? [{ name, isFlaky: false, message }] : failed;
  });
}
