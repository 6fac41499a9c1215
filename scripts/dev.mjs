import { requireNode } from './lib/node-version.mjs';

requireNode();
const { launch } = await import('./lib/commands.mjs');
const { choosePort, freePort, isOnLan } = await import('./lib/dev-port.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { inRoot, programFile } = await import('./lib/repository.mjs');
const { runScript } = await import('./lib/steps.mjs');
const { onStop } = await import('./lib/stopping.mjs');

await runScript(async () => {
  await ensureInstalled();
  const flags = process.argv.slice(2);
  const port = await choosePort(flags);
  const pagesPort = await freePort(5173);

  const master = launch(
    process.execPath,
    [
      programFile('', 'tsx'),
      'watch',
      '--clear-screen=false',
      inRoot('apps/master/src/main.ts'),
      // Development is for this machine only, unless flags say otherwise.
      ...(isOnLan(flags) || flags.includes('--host') ? [] : ['--lan', 'off']),
      ...flags,
      ...['--port', String(port)],
    ],
    { show: true, env: { UBII_DEV_FRONTEND_URL: `http://localhost:${pagesPort}` } },
  );
  const frontend = launch(
    process.execPath,
    [
      programFile('apps/frontend', 'vite'),
      ...['--port', String(pagesPort), '--strictPort', '--clearScreen', 'false'],
      ...(isOnLan(flags) ? ['--host'] : []),
    ],
    {
      cwd: inRoot('apps/frontend'),
      show: true,
      env: { UBII_DEV_MASTER_URL: `http://localhost:${port}` },
    },
  );

  const end = (/** @type {NodeJS.Signals} */ signal) => {
    master.end(signal);
    frontend.end(signal);
  };
  onStop(end);
  // Neither is of use without the other: whichever ends first takes the other along.
  const first = await Promise.race([master.ended, frontend.ended]);
  end('SIGTERM');
  await Promise.all([master.ended, frontend.ended]);
  process.exitCode = first.code;
});
