import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

import { run, runNode } from './commands.mjs';
import { fingerprint } from './fingerprint.mjs';
import { findUndocumentedErrors } from './documented-errors.mjs';
import { findRuleProblems } from './documented-rules.mjs';
import { followGuides } from './follow-guides.mjs';
import { inRoot, programFile, readJson } from './repository.mjs';
import { StepFailed, expectSuccess, step, stepsTogether } from './steps.mjs';
import { addCounts } from './test-results.mjs';
import { runTests } from './vitest.mjs';

/**
 * Everything that must hold before a change is committed. Throws StepFailed at the first thing that does not.
 *
 * @returns {Promise<import('./test-results.mjs').Counts>} counts of the unit and the process tests
 */
export async function runGate() {
  const { problems, notes } = await step('dependencies', async () => {
    // Needs packages, which may have been installed only now
    const { checkDependencies } = await import('./dependencies.mjs');
    return checkDependencies(Date.now());
  });
  for (const note of notes) process.stderr.write(`    ${note}\n`);
  expectNone(problems);
  // Writes sources, which all that follows reads
  await step('generated code unchanged', checkGeneratedCode);
  await stepsTogether(readingSteps());
  const unit = await step('unit tests', () => runTests('unit'));
  try {
    return addCounts([unit, await step('process tests', () => runTests('process'))]);
  } catch (error) {
    if (error.counts !== undefined) error.counts.passed += unit.passed;
    throw error;
  }
}

/**
 * Steps that only read the sources: the two longest first, so that none is left alone at the end, then the cheapest
 * first.
 */
function readingSteps() {
  return [
    { name: 'lint', work: tool('eslint', 'eslint', ['.', '--max-warnings', '0']) },
    { name: 'guides followed', work: followGuides },
    { name: 'format', work: tool('prettier', 'prettier', ['--check', '.', '--log-level', 'warn']) },
    {
      name: 'no import circles',
      work: tool('dependency-cruiser', 'depcruise', [
        ...['--config', 'dependency-cruiser.config.mjs', ...foldersInOrder()],
      ]),
    },
    { name: 'errors documented', work: async () => expectNone(findUndocumentedErrors()) },
    { name: 'rules quoted', work: async () => expectNone(findRuleProblems()) },
    { name: 'prose', work: checkWrittenWords },
    ...packagesWithTypes().map(({ name, folder }) => ({
      name: `types of ${name}`,
      work: async () => expectSuccess(await checkTypes(folder)),
    })),
    { name: 'tests of the scripts', work: testScripts },
  ];
}

/** @param {string} name package @param {string} program @param {readonly string[]} args */
function tool(name, program, args) {
  return async () => expectSuccess(await runNode(programFile('', name, program), args));
}

/** @param {readonly string[]} problems */
function expectNone(problems) {
  if (problems.length > 0) throw new StepFailed(problems.join('\n'));
}

async function checkWrittenWords() {
  const { checkWrittenFiles } = await import('./prose/check-prose.mjs');
  expectNone(await checkWrittenFiles());
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
async function checkGeneratedCode() {
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

async function testScripts() {
  // One by one: what `node --test` makes of a folder differs between versions of Node
  const tests = readdirSync(inRoot('scripts/lib'), { recursive: true })
    .filter((name) => name.endsWith('.test.mjs'))
    .map((name) => join('scripts', 'lib', name));
  expectSuccess(await run(process.execPath, ['--test', ...tests]));
}

/** Runs a package's own type check. @param {string} folder */
function checkTypes(folder) {
  return runNode(programFile('', 'pnpm'), [
    ...['--silent', '--dir', inRoot(folder), 'run', 'typecheck'],
  ]);
}
