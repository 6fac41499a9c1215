import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildMaster } from '@ubii/harness';

const inPackage = (path: string): string => fileURLToPath(new URL(`../${path}`, import.meta.url));
const bridgeFolder = inPackage('.cache/bridge/');
const masterFolder = inPackage('.cache/master/');

/** The built programs. */
export const bridgeProgram = join(bridgeFolder, 'main.js');
export const masterProgram = join(masterFolder, 'main.js');

/** Builds both programs into a folder of these tests, once for all test files. */
export function setup(): void {
  mkdirSync(inPackage('.cache'), { recursive: true });
  // The programs read their version from it.
  copyFileSync(inPackage('package.json'), inPackage('.cache/package.json'));
  execFileSync(process.execPath, [inPackage('build.mjs'), bridgeFolder], { stdio: 'inherit' });
  buildMaster(masterFolder);
}
