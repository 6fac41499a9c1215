import { parseArgs } from 'node:util';

import { requireNode } from './lib/node-version.mjs';

requireNode();
const { findChanges } = await import('./lib/changes.mjs');
const { checkGeneratedCode, quickTextSteps, runOtherGate, runQuickGate } =
  await import('./lib/gate.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { checkFormat, lintSources, lintTypesOfComponents, lintTypesOfFiles } =
  await import('./lib/lint.mjs');
const { runScript, step, stepsTogether } = await import('./lib/steps.mjs');
const { checkTypes, packagesWithTypes } = await import('./lib/types.mjs');
const { addCounts } = await import('./lib/test-results.mjs');
const { runTests } = await import('./lib/vitest.mjs');

const { values } = parseArgs({
  options: { all: { type: 'boolean', default: false }, since: { type: 'string' } },
});

await runScript(async () => {
  await ensureInstalled();
  const { passed } = values.all ? await checkAll() : await checkChanges();
  process.stderr.write(`  all fine, ${passed} tests passed\n`);
});

async function checkAll() {
  return addCounts([await runQuickGate(), ...(await runOtherGate())]);
}

/** Checks what has changed and what depends on it. */
async function checkChanges() {
  const { base, files, packages } = await findChanges(values.since);
  process.stderr.write(`  ${files.length} files changed since ${base.slice(0, 8)}\n`);
  if (files.length === 0) return { passed: 0 };
  const typed = files.filter((file) => file.endsWith('.ts'));
  const components = files.filter((file) => file.endsWith('.vue'));
  const sources = files.filter((file) => /\.(ts|vue|js|mjs)$/.test(file));
  await step('generated code unchanged', checkGeneratedCode);
  await stepsTogether([
    ...packagesWithTypes()
      .filter(({ name }) => packages.has(name))
      .map(({ name, folder }) => ({ name: `types of ${name}`, work: () => checkTypes(folder) })),
    ...(components.length > 0
      ? [{ name: 'lint of components with types', work: lintTypesOfComponents }]
      : []),
    ...(sources.length > 0 ? [{ name: 'lint', work: () => lintSources(sources) }] : []),
    ...(typed.length > 0 ? [{ name: 'lint with types', work: () => lintTypesOfFiles(typed) }] : []),
    { name: 'format', work: () => checkFormat(files) },
    ...quickTextSteps(),
  ]);
  return step('unit tests of what is affected', () =>
    runTests('unit', ['--changed', base, '--passWithNoTests']),
  );
}
