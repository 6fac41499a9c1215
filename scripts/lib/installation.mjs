import { existsSync, readFileSync } from 'node:fs';

import { run } from './commands.mjs';
import { inRoot, readJson } from './repository.mjs';
import { commandStep } from './steps.mjs';

/** Installs the locked dependencies when they are missing or not those of the lockfile. */
export async function ensureInstalled() {
  if (isInstalled()) return;
  const packageManager = readJson(inRoot('package.json')).packageManager;
  await commandStep(`install packages (${packageManager.replace('@', ' ')})`, () =>
    run('npx', ['-y', packageManager, 'install', '--frozen-lockfile', '--prefer-offline'], {
      // Without it pnpm asks a question when it wants to replace a node_modules it did not make.
      env: { CI: 'true' },
    }),
  );
}

/** pnpm keeps a copy of the lockfile it installed from, and writes its own record last. */
function isInstalled() {
  const installed = inRoot('node_modules', '.pnpm', 'lock.yaml');
  return (
    existsSync(installed) &&
    existsSync(inRoot('node_modules', '.modules.yaml')) &&
    readFileSync(installed).equals(readFileSync(inRoot('pnpm-lock.yaml')))
  );
}
