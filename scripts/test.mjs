import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureBrowser } = await import('./lib/browser.mjs');
const { ensureBuilt } = await import('./lib/builds.mjs');
const { runGate } = await import('./lib/gate.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { runScript } = await import('./lib/steps.mjs');
const { runBrowserTests, runInteropTests } = await import('./lib/suites.mjs');
const { addCounts, summary } = await import('./lib/test-results.mjs');

/** @type {import('./lib/test-results.mjs').Counts[]} */
const counts = [];
await runScript(async () => {
  try {
    await ensureInstalled();
    const browser = await ensureBrowser();
    counts.push(await runGate());
    await ensureBuilt();
    counts.push(await runBrowserTests(browser));
    counts.push(await runInteropTests());
  } catch (error) {
    counts.push(error.counts ?? { passed: 0, failed: 1 });
    throw error;
  }
});
if (addCounts(counts).failed > 0) process.exitCode = 1;
process.stdout.write(summary(counts));
