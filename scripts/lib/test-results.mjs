import { existsSync, mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';

import { formatFailedTests, readFailedTests } from './failed-tests.mjs';
import { cacheFolder, readJson } from './repository.mjs';

/** @typedef {{ passed: number, failed: number, tests?: import('./failed-tests.mjs').FailedTest[] }} Counts */

/**
 * Path for the JSON report of a test runner; an earlier report is removed.
 *
 * @param {string} name
 */
export function reportFile(name) {
  const folder = join(cacheFolder, 'reports');
  mkdirSync(folder, { recursive: true });
  const file = join(folder, `${name}.json`);
  rmSync(file, { force: true });
  return file;
}

/**
 * Reads the counts of a report of Vitest or Playwright. A run that ended badly without saying which
 * test failed (a file that does not load, no report at all) counts as one failure.
 *
 * @param {string} file
 * @param {number} exitCode of the test runner
 * @returns {Counts}
 */
export function readCounts(file, exitCode) {
  const report = existsSync(file) ? readJson(file) : {};
  const counts = report.stats
    ? { passed: report.stats.expected + report.stats.flaky, failed: report.stats.unexpected }
    : { passed: report.numPassedTests ?? 0, failed: report.numFailedTests ?? 0 };
  if (exitCode !== 0 && counts.failed === 0) counts.failed = 1;
  const tests = readFailedTests(file);
  return tests.length === 0 ? counts : { ...counts, tests };
}

/** @param {readonly Counts[]} all @returns {Counts} */
export function addCounts(all) {
  return {
    passed: all.reduce((sum, counts) => sum + counts.passed, 0),
    failed: all.reduce((sum, counts) => sum + counts.failed, 0),
  };
}

/**
 * The end of a run of tests: which failed and why, then, as the last line, the counts.
 *
 * @param {readonly Counts[]} all
 */
export function summary(all) {
  const { passed, failed } = addCounts(all);
  const tests = all.flatMap((counts) => counts.tests ?? []);
  return `${formatFailedTests(tests)}\n${passed} passed, ${failed} failed\n`;
}
