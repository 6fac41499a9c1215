import { runNode } from './commands.mjs';
import { programFile, root } from './repository.mjs';
import { StepFailed } from './steps.mjs';
import { readCounts, reportFile } from './test-results.mjs';

/** Fails unit tests that start processes or threads, or listen on sockets; `--import` takes a URL. */
const NO_PROCESSES = new URL('./no-processes.mjs', import.meta.url).href;

/** Projects of vitest.config.ts. The sandbox has a fifth of the time of all process tests. */
const PROJECTS = {
  unit: ['!process*'],
  process: ['process', 'process apps/*', 'process robustness'],
  sandbox: ['process packages/pm-sandbox'],
};

/**
 * Runs unit tests or process tests: `*.process.test.ts`, which start processes or threads, or listen on sockets.
 *
 * @param {keyof typeof PROJECTS} kind
 * @param {readonly string[]} [args] for Vitest
 * @returns {Promise<import('./test-results.mjs').Counts>}
 * @throws {StepFailed} with `counts` when a test fails
 */
export async function runTests(kind, args = []) {
  const report = reportFile(kind);
  const { code, output } = await runNode(
    programFile('', 'vitest'),
    [
      ...['run', '--root', root, ...PROJECTS[kind].flatMap((name) => ['--project', name])],
      ...['--reporter=dot', '--reporter=json', `--outputFile.json=${report}`],
      // Tests leave nothing behind and those with mocks reset modules, so sources are loaded once per worker instead of once per file
      '--no-isolate',
      ...args,
    ],
    { env: { NO_COLOR: '1', ...(kind === 'unit' && { NODE_OPTIONS: nodeOptions() }) } },
  );
  const counts = readCounts(report, code);
  if (code !== 0) throw Object.assign(new StepFailed(output), { counts });
  return counts;
}

function nodeOptions() {
  return [process.env.NODE_OPTIONS, `--import=${NO_PROCESSES}`].filter(Boolean).join(' ');
}
