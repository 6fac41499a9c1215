import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureBuilt, modelsProgram } = await import('./lib/builds.mjs');
const { launch } = await import('./lib/commands.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { inRoot } = await import('./lib/repository.mjs');
const { runScript } = await import('./lib/steps.mjs');
const { onStop } = await import('./lib/stopping.mjs');

await runScript(async () => {
  await ensureInstalled();
  await ensureBuilt(['master', 'vision']);
  const models = launch(
    process.execPath,
    ['--enable-source-maps', inRoot(modelsProgram), ...process.argv.slice(2)],
    { cwd: process.cwd(), show: true, ownedByUs: true },
  );
  onStop((signal) => models.end(signal));
  process.exitCode = (await models.ended).code;
});
