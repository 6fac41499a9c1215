import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureBrowser } = await import('./lib/browser.mjs');
const { ensureBuilt } = await import('./lib/builds.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { runScript } = await import('./lib/steps.mjs');
const { takePictures } = await import('./lib/suites.mjs');

await runScript(async () => {
  await ensureInstalled();
  await ensureBuilt();
  process.exitCode = await takePictures(await ensureBrowser(), process.argv.slice(2));
});
