import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

import { runNode } from './commands.mjs';
import { inRoot, programFile, readJson } from './repository.mjs';
import { expectSuccess } from './steps.mjs';

/**
 * Workspace folders with a check of their types, those that take longest first.
 *
 * @returns {{ name: string, folder: string }[]}
 */
export function packagesWithTypes() {
  return ['apps', 'demos', '.', 'packages']
    .flatMap((parent) =>
      readdirSync(inRoot(parent), { withFileTypes: true })
        .filter((entry) => entry.isDirectory())
        .map((entry) => join(parent, entry.name)),
    )
    .filter((folder) => existsSync(inRoot(folder, 'package.json')))
    .map((folder) => ({ folder, ...readJson(inRoot(folder, 'package.json')) }))
    .filter(({ scripts }) => scripts?.typecheck !== undefined)
    .map(({ name, folder }) => ({ name, folder }));
}

/** Runs a package's own type check. @param {string} folder */
export async function checkTypes(folder) {
  const args = ['--silent', '--dir', inRoot(folder), 'run', 'typecheck'];
  expectSuccess(await runNode(programFile('', 'pnpm'), args));
}
