import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const folder = fileURLToPath(new URL('..', import.meta.url));
const output = join(folder, '.cache-package');

/** The built package: its content, and what a master serves. */
export const builtPackage = join(output, 'package');
export const builtSdk = join(output, 'sdk');

/** Builds the package into a folder of these tests, once for all test files. */
export function setup(): void {
  execFileSync(process.execPath, [join(folder, 'build.mjs'), '.cache-package'], {
    stdio: 'inherit',
  });
}
