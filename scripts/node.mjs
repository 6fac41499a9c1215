import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureBuilt, nodeProgram } = await import('./lib/builds.mjs');
const { launch } = await import('./lib/commands.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { inRoot } = await import('./lib/repository.mjs');
const { runScript } = await import('./lib/steps.mjs');
const { onStop } = await import('./lib/stopping.mjs');

await runScript(async () => {
  await ensureInstalled();
  await ensureBuilt(['node']);
  const node = launch(
    process.execPath,
    ['--enable-source-maps', inRoot(nodeProgram), ...process.argv.slice(2)],
    // Folders in the flags are meant from where the person stands, which npm tells.
    { cwd: process.env.INIT_CWD ?? process.cwd(), show: true, ownedByUs: true },
  );
  onStop((signal) => node.end(signal));
  process.exitCode = (await node.ended).code;
});
