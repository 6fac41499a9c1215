import { requireNode } from './lib/node-version.mjs';

requireNode();
const { runGate } = await import('./lib/gate.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { runScript } = await import('./lib/steps.mjs');

await runScript(async () => {
  await ensureInstalled();
  const { passed } = await runGate();
  process.stderr.write(`  all fine, ${passed} unit tests passed\n`);
});
