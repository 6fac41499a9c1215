import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureBuilt } = await import('./lib/builds.mjs');
const { runNode } = await import('./lib/commands.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { inRoot, programFile } = await import('./lib/repository.mjs');
const { runScript } = await import('./lib/steps.mjs');

await runScript(async () => {
  await ensureInstalled();
  await ensureBuilt(['master']);
  const tsx = programFile('benchmarks', 'tsx');
  const { code } = await runNode(tsx, ['src/main.ts', ...process.argv.slice(2)], {
    cwd: inRoot('benchmarks'),
    show: true,
  });
  process.exitCode = code;
});
