import { runNode } from './commands.mjs';
import { inRoot, programFile, readJson } from './repository.mjs';
import { StepFailed } from './steps.mjs';
import { readCounts, reportFile } from './test-results.mjs';

/**
 * Runs the tests in real browsers; their progress goes to the screen.
 *
 * @param {string} browser path of Chromium
 * @param {readonly string[]} [args] for Playwright
 */
export async function runBrowserTests(browser, args = []) {
  const report = reportFile('e2e');
  const { code } = await runScriptOfE2e('e2e', ['--reporter=list,json', ...args], {
    UBII_CHROMIUM: browser,
    PLAYWRIGHT_JSON_OUTPUT_NAME: report,
  });
  return readCounts(report, code);
}

/** Runs the tests with existing clients of other makers; their progress goes to the screen. */
export async function runInteropTests() {
  const report = reportFile('interop');
  const { code } = await runScriptOfE2e('interop', [
    ...['--reporter=verbose', '--reporter=json', `--outputFile.json=${report}`],
  ]);
  return readCounts(report, code);
}

/** @param {string} name @param {readonly string[]} args @param {Record<string, string>} [env] */
function runScriptOfE2e(name, args, env) {
  if (readJson(inRoot('e2e/package.json')).scripts[name] === undefined) {
    throw new StepFailed(`e2e/package.json has no script "${name}".`);
  }
  const pnpm = programFile('', 'pnpm');
  return runNode(pnpm, ['--silent', '--dir', inRoot('e2e'), 'run', name, ...args], {
    env,
    show: true,
  });
}
