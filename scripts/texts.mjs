import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureInstalled } = await import('./lib/installation.mjs');
const { runScript } = await import('./lib/steps.mjs');

await runScript(async () => {
  await ensureInstalled();
  const { writtenFiles } = await import('./lib/prose/files.mjs');
  const { textsOfScreens } = await import('./lib/prose/texts-of-screens.mjs');
  for (const [feature, lines] of textsOfScreens(writtenFiles(), process.argv[2])) {
    process.stdout.write(`${feature}\n${lines.map((line) => `  ${line}\n`).join('')}\n`);
  }
});
