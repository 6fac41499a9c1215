import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildMaster } from '@ubii/harness';

const folder = fileURLToPath(new URL('..', import.meta.url));
const output = join(folder, '.cache-package');

/** The built package: its content, and what a master serves. */
export const builtPackage = join(output, 'package');
export const builtSdk = join(output, 'sdk');

/** Main file of the master of these tests, built away from where others build it. */
export const ownMaster = join(folder, '.cache', 'main.js');

/** Builds the package and the master into folders of these tests, once for all test files. */
export function setup(): void {
  execFileSync(process.execPath, [join(folder, 'build.mjs'), '.cache-package'], {
    stdio: 'inherit',
  });
  buildMaster(join(folder, '.cache'));
}
