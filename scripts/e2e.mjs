import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureBrowser } = await import('./lib/browser.mjs');
const { ensureBuilt } = await import('./lib/builds.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { runScript } = await import('./lib/steps.mjs');
const { runBrowserTests, runInteropTests } = await import('./lib/suites.mjs');
const { addCounts, summary } = await import('./lib/test-results.mjs');

await runScript(async () => {
  await ensureInstalled();
  await ensureBuilt();
  const args = process.argv.slice(2);
  const counts = [await runBrowserTests(await ensureBrowser(), args)];
  // Arguments choose among the browser tests; then the others are not meant.
  if (args.length === 0) counts.push(await runInteropTests());
  process.stdout.write(summary(counts));
  if (addCounts(counts).failed > 0) process.exitCode = 1;
});
