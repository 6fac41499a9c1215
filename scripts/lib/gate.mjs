import { existsSync, mkdirSync, readdirSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';

import { run, runNode } from './commands.mjs';
import { findUndocumentedErrors } from './documented-errors.mjs';
import { findRuleProblems } from './documented-rules.mjs';
import { fingerprint } from './fingerprint.mjs';
import { findFolderCircles } from './folder-circles.mjs';
import { followGuides } from './follow-guides.mjs';
import { checkFormat, lintSources, lintTypesOfComponents, lintTypesOfFiles } from './lint.mjs';
import { cacheFolder, inRoot, programFile, readJson } from './repository.mjs';
import { StepFailed, expectSuccess, step, stepsTogether } from './steps.mjs';
import { checkTypes, packagesWithTypes } from './types.mjs';
import { runTests } from './vitest.mjs';

const HALF_OF_THE_CORES = `--maxWorkers=${Math.max(1, Math.floor(availableParallelism() / 2))}`;

/**
 * What most changes break: format, lint, types, unit tests. Throws StepFailed at the first thing that does not hold.
 *
 * @returns {Promise<import('./test-results.mjs').Counts>} counts of the unit tests
 */
export async function runQuickGate() {
  // Writes sources, which all that follows reads
  await step('generated code unchanged', checkGeneratedCode);
  await stepsTogether([
    { name: 'lint', work: () => lintSources() },
    ...packagesWithTypes().map(({ name, folder }) => ({
      name: `types of ${name}`,
      work: () => checkTypes(folder),
    })),
    { name: 'format', work: () => checkFormat() },
    { name: 'lint with types', work: () => lintTypesOfFiles() },
    { name: 'lint of components with types', work: lintTypesOfComponents },
  ]);
  return step('unit tests', () => runTests('unit'));
}

/**
 * A suite of tests that needs no more than one core.
 *
 * @typedef {{ name: string, work: () => Promise<import('./test-results.mjs').Counts> }} Suite
 */

/**
 * Everything else that must hold before a change lands. Throws StepFailed at the first thing that does not.
 *
 * @param {readonly Suite[]} [suites] run beside the process tests, which wait a quarter of their time
 * @returns {Promise<import('./test-results.mjs').Counts[]>} counts of the process tests and of the suites
 */
export async function runOtherGate(suites = []) {
  const { problems, notes } = await step('dependencies', async () => {
    // Needs packages, which may have been installed only now
    const { checkDependencies } = await import('./dependencies.mjs');
    return checkDependencies(Date.now());
  });
  for (const note of notes) process.stderr.write(`    ${note}\n`);
  expectNone(problems);
  /** @type {import('./test-results.mjs').Counts[]} */
  const counts = [];
  const counted = (/** @type {Suite} */ { name, work }) => ({
    name,
    work: async () => counts.push(await work()),
  });
  // The longest first, so that none is left alone at the end
  await stepsTogether([
    counted({ name: 'process tests', work: () => runTests('process', [HALF_OF_THE_CORES]) }),
    { name: 'guides followed', work: followGuides },
    ...suites.map(counted),
    counted({
      name: 'process tests of the sandbox',
      work: () => runTests('sandbox', [HALF_OF_THE_CORES]),
    }),
    { name: 'no import circles', work: checkImportOrder },
    ...quickTextSteps(),
    { name: 'tests of the scripts', work: testScripts },
  ]);
  return counts;
}

/** Checks of all texts that take seconds. */
export function quickTextSteps() {
  return [
    { name: 'prose', work: checkWrittenWords },
    { name: 'errors documented', work: async () => expectNone(findUndocumentedErrors()) },
    { name: 'rules quoted', work: async () => expectNone(findRuleProblems()) },
  ];
}

/** @param {readonly string[]} problems */
function expectNone(problems) {
  if (problems.length > 0) throw new StepFailed(problems.join('\n'));
}

async function checkWrittenWords() {
  const { checkWrittenFiles } = await import('./prose/check-prose.mjs');
  expectNone(await checkWrittenFiles());
}

async function checkImportOrder() {
  mkdirSync(cacheFolder, { recursive: true });
  const found = join(cacheFolder, 'imports.json');
  expectSuccess(
    await runNode(programFile('', 'dependency-cruiser', 'depcruise'), [
      ...['--config', 'dependency-cruiser.config.mjs', ...foldersInOrder()],
      ...['--output-type', 'json', '--output-to', found],
    ]),
  );
  const format = programFile('', 'dependency-cruiser', 'depcruise-fmt');
  expectSuccess(await runNode(format, ['--output-type', 'err', '--exit-code', found]));
  expectNone(findFolderCircles(readJson(found).modules));
}

/** Sources whose files and folders import each other in one order. */
function foldersInOrder() {
  const packages = ['packages', 'demos'].flatMap((parent) =>
    readdirSync(inRoot(parent)).map((name) => join(parent, name, 'src')),
  );
  return [
    'apps/master/src',
    'apps/node/src',
    'apps/bridge/src',
    'apps/frontend/src',
    'benchmarks/src',
    'e2e/fixtures',
    'e2e/interop',
    'e2e/pages',
    'e2e/tests',
    'robustness/src',
    ...packages.filter((path) => existsSync(inRoot(path))),
  ];
}

/** Generating again must change nothing: what is committed was made from the schema beside it. */
export async function checkGeneratedCode() {
  const generated = ['packages/proto/src/generated'];
  const before = fingerprint(generated);
  expectSuccess(
    await runNode(programFile('packages/proto', 'tsx'), ['scripts/generate.ts'], {
      cwd: inRoot('packages/proto'),
    }),
  );
  if (fingerprint(generated) !== before) {
    throw new StepFailed(
      `${generated} was not made from packages/proto/schema as it is now. It has been made again: look at the difference and commit it.`,
    );
  }
}

async function testScripts() {
  // One by one: what `node --test` makes of a folder differs between versions of Node
  const tests = readdirSync(inRoot('scripts/lib'), { recursive: true })
    .filter((name) => name.endsWith('.test.mjs'))
    .map((name) => join('scripts', 'lib', name));
  expectSuccess(await run(process.execPath, ['--test', ...tests]));
}
