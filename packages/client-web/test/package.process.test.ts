import { execFile } from 'node:child_process';
import { cpSync, mkdirSync, readFileSync, readdirSync, utimesSync, writeFileSync } from 'node:fs';
import { isBuiltin } from 'node:module';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { gzipSync } from 'node:zlib';
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { temporaryFolder } from '@ubii/program/testing';
import { build } from 'esbuild';
import { publint } from 'publint';
import { describe, expect, it } from 'vitest';

import { packFolder } from '../packaging/pack-folder.mjs';
import { builtPackage, builtSdk } from './build-package.ts';

const packageFolder = fileURLToPath(new URL('..', import.meta.url));
const guide = readFileSync(join(packageFolder, '../../docs/guides/a-program.md'), 'utf8');
const archiveName = readdirSync(builtSdk).find((name) => name.endsWith('.tgz')) ?? '';
const archive = readFileSync(join(builtSdk, archiveName));

/** Content of the package, with hashes of chunks left out. */
function filesOfPackage(): string[] {
  const names = readdirSync(builtPackage, { recursive: true, encoding: 'utf8' });
  return [...new Set(names.map((name) => name.replace(/-[0-9A-Z]{8}\.js$/, '.js')))].sort();
}

/** Bundles an entry as its users may: everything that it imports has to be there. */
async function importsOf(entry: string, platform: 'browser' | 'node'): Promise<string[]> {
  const { metafile } = await build({
    entryPoints: [join(builtPackage, entry)],
    bundle: true,
    write: false,
    format: 'esm',
    metafile: true,
    platform,
    logLevel: 'silent',
  });
  return Object.values(metafile.outputs).flatMap(({ imports }) => imports.map(({ path }) => path));
}

describe('the package', () => {
  it('has these files', () => {
    expect(filesOfPackage()).toEqual([
      'LICENSE',
      'README.md',
      'THIRD-PARTY-LICENCES.txt',
      'chunks',
      'chunks/chunk.js',
      'chunks/master-proof.js',
      'chunks/re2.js',
      'index.d.ts',
      'index.js',
      'module-worker.js',
      'node.d.ts',
      'node.js',
      'package.json',
      'processing.d.ts',
      'processing.js',
    ]);
  });

  it('has the licences of all packages that are bundled', () => {
    const text = readFileSync(join(builtPackage, 'THIRD-PARTY-LICENCES.txt'), 'utf8');
    for (const name of ['ws', 're2js', '@noble/hashes', 'quickjs-emscripten-core']) {
      expect(text).toMatch(new RegExp(`^${name} \\d`, 'm'));
    }
    expect(text).toContain('Permission is hereby granted');
  });

  it('has nothing left to install', async () => {
    const manifest = JSON.parse(readFileSync(join(builtPackage, 'package.json'), 'utf8')) as object;
    expect(manifest).not.toHaveProperty('dependencies');
    expect(await importsOf('index.js', 'browser')).toEqual([]);
    for (const entry of ['node.js', 'processing.js', 'module-worker.js']) {
      const others = (await importsOf(entry, 'node')).filter((path) => !isBuiltin(path));
      expect(others).toEqual([]);
    }
  });

  it('is as publint wants it', async () => {
    const { messages } = await publint({ pkgDir: builtPackage, pack: false, strict: true });
    expect(messages).toEqual([]);
  });

  it('has types that are found by all ways to import it [are the types wrong]', async () => {
    const result = await checkPackage(createPackageFromTarballData(archive));
    // ES modules only: CommonJS and the resolution of Node 10 have no way to its entries.
    const problems = (result.types === false ? [] : result.problems).filter(
      (problem) =>
        problem.kind !== 'CJSResolvesToESM' &&
        !('resolutionKind' in problem && problem.resolutionKind === 'node10'),
    );
    expect(result.types).not.toBe(false);
    expect(problems).toEqual([]);
  });

  it('has types that hold for the samples, without those of other packages', async () => {
    const folder = temporaryFolder();
    const installed = join(folder, 'node_modules/@ubii/client-web');
    mkdirSync(installed, { recursive: true });
    cpSync(builtPackage, installed, { recursive: true });
    cpSync(join(packageFolder, 'samples'), folder, { recursive: true });
    writeFileSync(join(folder, 'process.d.ts'), 'declare const process: { argv: string[] };');
    const page =
      "import { createClient } from '@ubii/client-web';\ncreateClient({ name: 'a' }).publish('/a', 'bool', true);\n// @ts-expect-error -- another format\ncreateClient({ name: 'a' }).publish('/a', 'bool', 1);\n";
    writeFileSync(join(folder, 'page.ts'), page);
    const tsc = join(packageFolder, 'node_modules/typescript/bin/tsc');
    const flags = ['--noEmit', '--strict', '--allowJs', '--checkJs', '--module', 'nodenext'];
    const libraries = [
      '--target',
      'es2022',
      '--lib',
      'es2023,dom,dom.asynciterable',
      '--types',
      '',
    ];
    const files = ['first-program.mjs', 'first-module.mjs', 'page.ts', 'process.d.ts'];
    const run = promisify(execFile)(process.execPath, [tsc, ...flags, ...libraries, ...files], {
      cwd: folder,
    });
    const output = await run.then(
      ({ stdout }) => stdout,
      ({ stdout }: { stdout: string }) => stdout,
    );
    expect(output).toBe('');
  });

  it('has the same bytes whenever its files were written', () => {
    const copy = join(temporaryFolder(), 'package');
    cpSync(builtPackage, copy, { recursive: true });
    utimesSync(join(copy, 'node.js'), 1, 1);
    expect(packFolder(copy).equals(archive)).toBe(true);
  });
});

describe('the guide', () => {
  const unpackedBytes = readdirSync(builtPackage, { recursive: true, encoding: 'utf8' })
    .map((name) => join(builtPackage, name))
    .reduce((sum, file) => sum + (readIfFile(file)?.length ?? 0), 0);
  const script = readFileSync(join(builtSdk, 'ubii-client.js'));

  it('says how large the package is, which has limits', () => {
    const said = /archive has ([\d.]+) MB, unpacked ([\d.]+) MB/.exec(guide)!.slice(1).map(Number);
    expect(said[0]! / (archive.length / 1e6)).toBeCloseTo(1, 1);
    expect(said[1]! / (unpackedBytes / 1e6)).toBeCloseTo(1, 1);
    const [, minified] = /minified: (\d+) kB/.exec(guide)!;
    expect(Number(minified) / (script.length / 1e3)).toBeCloseTo(1, 1);
    expect(archive.length).toBeLessThan(1_000_000);
    expect(gzipSync(script).length).toBeLessThan(125_000);
  });
});

function readIfFile(path: string): Buffer | undefined {
  try {
    return readFileSync(path);
  } catch {
    return undefined; // A folder.
  }
}
