import { existsSync, readFileSync } from 'node:fs';

/**
 * Returns the version in the `package.json` one folder above a file, which is the same from `src` and from `dist`.
 *
 * @param programUrl `import.meta.url` of the file
 */
export function readVersion(programUrl: string): string {
  const manifest = readFileSync(new URL('../package.json', programUrl), 'utf8');
  return (JSON.parse(manifest) as { version: string }).version;
}

/** Returns the folder of the person who ran an npm script, which npm runs in the folder of its package. */
export function callerFolder(): string {
  return process.env['INIT_CWD'] ?? process.cwd();
}

/**
 * Returns a file that is built beside a program. A program that runs from its sources uses the last build.
 *
 * @param programUrl `import.meta.url` of a file of the program
 */
export function findBuilt(name: string, programUrl: string): URL {
  const beside = new URL(name, programUrl);
  return existsSync(beside) ? beside : new URL(`../dist/${name}`, programUrl);
}
