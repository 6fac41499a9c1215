import { parseArgs } from 'node:util';

import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureBrowser, ensureFirefox } = await import('./lib/browser.mjs');
const { ensureBuilt } = await import('./lib/builds.mjs');
const { runOtherGate, runQuickGate } = await import('./lib/gate.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { runScript } = await import('./lib/steps.mjs');
const { runBrowserTests, runFirefoxTests, runInteropTests } = await import('./lib/suites.mjs');
const { addCounts, summary } = await import('./lib/test-results.mjs');

/** Some stories run in Firefox as well, which has its own step. */
const CHROMIUM = ['--project', 'chromium'];

/** Without an option: what answers within minutes. `--all`: everything; `--rest`: everything else. */
const { values } = parseArgs({
  options: { all: { type: 'boolean' }, rest: { type: 'boolean' } },
});

/** @type {import('./lib/test-results.mjs').Counts[]} */
const counts = [];
await runScript(async () => {
  try {
    await ensureInstalled();
    const browser = await ensureBrowser();
    if (!values.rest) {
      counts.push(await runQuickGate());
      await ensureBuilt();
      counts.push(await runBrowserTests(browser, [...CHROMIUM, '--grep', '@smoke']));
      if (addCounts(counts).failed > 0) return;
    }
    if (!values.rest && !values.all) return;
    await ensureBuilt();
    const suites = [{ name: 'existing clients', work: runInteropTests }];
    if (await ensureFirefox()) suites.push({ name: 'stories in Firefox', work: runFirefoxTests });
    else process.stderr.write('  No Firefox: its stories are left out.\n');
    counts.push(...(await runOtherGate(suites)));
    counts.push(await runBrowserTests(browser, [...CHROMIUM, '--grep-invert', '@smoke']));
  } catch (error) {
    counts.push(error.counts ?? { passed: 0, failed: 1 });
    throw error;
  }
});
if (addCounts(counts).failed > 0) process.exitCode = 1;
process.stdout.write(summary(counts));
