import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureBuilt, masterProgram } = await import('./lib/builds.mjs');
const { launch } = await import('./lib/commands.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { inRoot } = await import('./lib/repository.mjs');
const { runScript } = await import('./lib/steps.mjs');
const { onStop } = await import('./lib/stopping.mjs');

await runScript(async () => {
  await ensureInstalled();
  // Modules that see get their models and libraries from the master.
  await ensureBuilt(['master', 'frontend', 'vision']);
  const master = launch(
    process.execPath,
    ['--enable-source-maps', inRoot(masterProgram), ...process.argv.slice(2)],
    { cwd: process.cwd(), show: true, ownedByUs: true },
  );
  onStop((signal) => master.end(signal));
  process.exitCode = (await master.ended).code;
});
