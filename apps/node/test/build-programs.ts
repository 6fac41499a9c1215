import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { buildMaster } from '@ubii/harness';

const inPackage = (path: string): string => fileURLToPath(new URL(`../${path}`, import.meta.url));
const nodeFolder = inPackage('.cache/node/');
const masterFolder = inPackage('.cache/master/');

/** The built programs. */
export const nodeProgram = join(nodeFolder, 'main.js');
export const recordingsProgram = join(nodeFolder, 'recordings.js');
export const masterProgram = join(masterFolder, 'main.js');

/** Builds both programs into a folder of these tests, once for all test files. */
export function setup(): void {
  mkdirSync(inPackage('.cache'), { recursive: true });
  // The programs read their version from it.
  copyFileSync(inPackage('package.json'), inPackage('.cache/package.json'));
  execFileSync(process.execPath, [inPackage('build.mjs'), nodeFolder], { stdio: 'inherit' });
  buildMaster(masterFolder);
}
