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
  const env = { UBII_CHROMIUM: browser, PLAYWRIGHT_JSON_OUTPUT_NAME: report };
  const { code } = await runScriptOfE2e('e2e', ['--reporter=list,json', ...args], {
    env,
    show: true,
  });
  return readCounts(report, code);
}

/**
 * Runs the stories that also run in Firefox, one at a time. They say something only when one fails.
 *
 * @throws {StepFailed} with `counts` when a test fails
 */
export async function runFirefoxTests() {
  const report = reportFile('firefox');
  const args = ['--reporter=list,json', '--project', 'firefox', '--workers', '1'];
  const env = { PLAYWRIGHT_JSON_OUTPUT_NAME: report };
  return expectPassed(report, await runScriptOfE2e('e2e', args, { env }));
}

/**
 * Runs the tests with existing clients of other makers. They say something only when one fails.
 *
 * @throws {StepFailed} with `counts` when a test fails
 */
export async function runInteropTests() {
  const report = reportFile('interop');
  const args = ['--reporter=verbose', '--reporter=json', `--outputFile.json=${report}`];
  return expectPassed(report, await runScriptOfE2e('interop', args));
}

/**
 * Takes pictures of the documents again; the progress goes to the screen.
 *
 * @param {string} browser path of Chromium
 * @param {readonly string[]} args for Playwright
 * @returns {Promise<number>} exit code
 */
export async function takePictures(browser, args) {
  const env = { UBII_CHROMIUM: browser };
  const { code } = await runScriptOfE2e('pictures', args, { env, show: true });
  return code;
}

/** @param {string} report @param {{ code: number, output: string }} result */
function expectPassed(report, { code, output }) {
  const counts = readCounts(report, code);
  if (counts.failed > 0) throw Object.assign(new StepFailed(output), { counts });
  return counts;
}

/** @param {string} name @param {readonly string[]} args @param {import('./commands.mjs').CommandOptions} [options] */
function runScriptOfE2e(name, args, options) {
  if (readJson(inRoot('e2e/package.json')).scripts[name] === undefined) {
    throw new StepFailed(`e2e/package.json has no script "${name}".`);
  }
  const pnpm = programFile('', 'pnpm');
  return runNode(pnpm, ['--silent', '--dir', inRoot('e2e'), 'run', name, ...args], options);
}
