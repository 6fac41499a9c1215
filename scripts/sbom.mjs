import { writeFileSync } from 'node:fs';

import { requireNode } from './lib/node-version.mjs';

requireNode();
const { installedLicences } = await import('./lib/dependency-licences.mjs');
const { ensureInstalled } = await import('./lib/installation.mjs');
const { readLock } = await import('./lib/lockfile.mjs');
const { inRoot, readJson } = await import('./lib/repository.mjs');
const { createSbom } = await import('./lib/sbom.mjs');
const { runScript } = await import('./lib/steps.mjs');

await runScript(async () => {
  await ensureInstalled();
  const sbom = createSbom(readLock(), readJson(inRoot('package.json')), installedLicences());
  writeFileSync(inRoot('sbom.cdx.json'), `${JSON.stringify(sbom, undefined, 2)}\n`);
  process.stderr.write(`  ${sbom.components.length} packages in sbom.cdx.json\n`);
});
