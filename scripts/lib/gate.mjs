import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

import { run, runNode } from './commands.mjs';
import { fingerprint } from './fingerprint.mjs';
import { findUndocumentedErrors } from './documented-errors.mjs';
import { findRuleProblems } from './documented-rules.mjs';
import { followGuides } from './follow-guides.mjs';
import { inRoot, programFile, readJson, root } from './repository.mjs';
import { StepFailed, commandStep, step } from './steps.mjs';
import { readCounts, reportFile } from './test-results.mjs';

/**
 * Everything that must hold before a change is committed, cheapest first. Throws StepFailed at the
 * first thing that does not.
 *
 * @returns {Promise<import('./test-results.mjs').Counts>} counts of the unit tests
 */
export async function runGate() {
  await commandStep('format', () =>
    runNode(programFile('', 'prettier'), ['--check', '.', '--log-level', 'warn']),
  );
  await commandStep('no import circles', () =>
    runNode(programFile('', 'dependency-cruiser', 'depcruise'), [
      ...['--config', 'dependency-cruiser.config.mjs', ...foldersInOrder()],
    ]),
  );
  await step('errors documented', async () => {
    const problems = findUndocumentedErrors();
    if (problems.length > 0) throw new StepFailed(problems.join('\n'));
  });
  await step('rules quoted', async () => {
    const problems = findRuleProblems();
    if (problems.length > 0) throw new StepFailed(problems.join('\n'));
  });
  const { problems, notes } = await step('dependencies', async () => {
    // Needs packages, which may have been installed only now
    const { checkDependencies } = await import('./dependencies.mjs');
    return checkDependencies(Date.now());
  });
  for (const note of notes) process.stderr.write(`    ${note}\n`);
  if (problems.length > 0) throw new StepFailed(problems.join('\n'));
  await step('generated code unchanged', checkGeneratedCode);
  await step('prose', async () => {
    const { checkWrittenFiles } = await import('./prose/check-prose.mjs');
    const findings = await checkWrittenFiles();
    if (findings.length > 0) throw new StepFailed(findings.join('\n'));
  });
  for (const pair of pairs(packagesWithTypes())) {
    await step(`types of ${pair.map(({ name }) => name).join(' and ')}`, async () => {
      const results = await Promise.all(pair.map(({ folder }) => checkTypes(folder)));
      const failed = results.filter(({ code }) => code !== 0);
      if (failed.length > 0) throw new StepFailed(failed.map(({ output }) => output).join('\n'));
    });
  }
  await commandStep('tests of the scripts', () =>
    run(process.execPath, ['--test', ...scriptTests()]),
  );
  await commandStep('lint', () => runNode(programFile('', 'eslint'), ['.', '--max-warnings', '0']));
  await step('guides followed', followGuides);
  return step('unit tests', runUnitTests);
}

/** Sources whose files and folders import each other in one order. */
function foldersInOrder() {
  const packages = ['packages', 'demos'].flatMap((parent) =>
    readdirSync(inRoot(parent)).map((name) => join(parent, name, 'src')),
  );
  return [
    'apps/master/src',
    'apps/node/src',
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
async function checkGeneratedCode() {
  const generated = ['packages/proto/src/generated'];
  const before = fingerprint(generated);
  const { code, output } = await runNode(
    programFile('packages/proto', 'tsx'),
    ['scripts/generate.ts'],
    { cwd: inRoot('packages/proto') },
  );
  if (code !== 0) throw new StepFailed(output);
  if (fingerprint(generated) !== before) {
    throw new StepFailed(
      `${generated} was not made from packages/proto/schema as it is now. It has been made again: look at the difference and commit it.`,
    );
  }
}

/** Workspace folders with their own tsconfig. */
function packagesWithTypes() {
  return ['packages', 'apps', 'demos', '.']
    .flatMap((parent) =>
      readdirSync(inRoot(parent), { withFileTypes: true })
        .filter((entry) => entry.isDirectory())
        .map((entry) => join(parent, entry.name)),
    )
    .filter((folder) => existsSync(inRoot(folder, 'package.json')))
    .map((folder) => ({ folder, ...readJson(inRoot(folder, 'package.json')) }))
    .filter(({ scripts }) => scripts?.typecheck !== undefined);
}

/** One by one: what `node --test` makes of a folder differs between versions of Node. */
function scriptTests() {
  return readdirSync(inRoot('scripts/lib'), { recursive: true })
    .filter((name) => name.endsWith('.test.mjs'))
    .map((name) => join('scripts', 'lib', name));
}

/** Runs a package's own type check. @param {string} folder */
function checkTypes(folder) {
  return runNode(programFile('', 'pnpm'), [
    ...['--silent', '--dir', inRoot(folder), 'run', 'typecheck'],
  ]);
}

async function runUnitTests() {
  const report = reportFile('unit');
  const { code, output } = await runNode(programFile('', 'vitest'), [
    ...['run', '--root', root, '--reporter=dot', '--reporter=json', `--outputFile.json=${report}`],
    // Tests leave nothing behind and those with mocks reset modules, so sources are loaded once per worker instead of once per file
    '--no-isolate',
  ]);
  if (code !== 0) {
    throw Object.assign(new StepFailed(output), { counts: readCounts(report, code) });
  }
  return readCounts(report, code);
}

/** @template T @param {readonly T[]} list @returns {T[][]} two at a time: more does not fit a small machine */
function pairs(list) {
  return list.flatMap((_, index) => (index % 2 === 0 ? [list.slice(index, index + 2)] : []));
}
