import { writeFileSync } from 'node:fs';

import { requireNode } from './lib/node-version.mjs';

requireNode();
const { ensureInstalled } = await import('./lib/installation.mjs');
const { StepFailed, runScript } = await import('./lib/steps.mjs');

/** The public registry, unless npm is told another one. */
const registry = process.env.npm_config_registry ?? 'https://registry.npmjs.org/';

await runScript(async () => {
  await ensureInstalled();
  const { advisoriesFromAnswer, versionsByName } = await import('./lib/advisories.mjs');
  const { advisoryFile } = await import('./lib/dependencies.mjs');
  const { readLock } = await import('./lib/lockfile.mjs');
  const asked = versionsByName(readLock().packages.values());
  const advisories = advisoriesFromAnswer(await ask(asked));
  const updated = new Date().toISOString().slice(0, 10);
  const source = 'npm registry, all locked versions';
  const file = { updated, source, asked, advisories };
  writeFileSync(advisoryFile, `${JSON.stringify(file, undefined, 2)}\n`);
  process.stderr.write(
    `  advisories for ${Object.keys(advisories).length} of ${Object.keys(asked).length} packages in security/advisories.json\n`,
  );
});

/** https://docs.npmjs.com/cli/v11/commands/npm-audit: the endpoint `npm audit` asks. */
async function ask(asked) {
  const url = new URL('-/npm/v1/security/advisories/bulk', registry);
  const failed = (reason) =>
    new StepFailed(
      `The advisories could not be fetched: ${reason}. security/advisories.json is as it was.`,
    );
  let response;
  try {
    response = await fetch(url, {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify(asked),
    });
  } catch (error) {
    throw failed(error.cause?.message ?? error.message);
  }
  if (!response.ok) throw failed(`the registry answered with ${response.status}`);
  return response.json();
}
