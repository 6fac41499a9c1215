import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync } from 'node:fs';
import { cp, mkdir, mkdtemp, readdir, readFile, rename, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { promisify } from 'node:util';
import type { ClientKind } from './client-kind.ts';

const run = promisify(execFile);
const CLIENTS = join(import.meta.dirname, '../clients');
const CACHE = join(import.meta.dirname, '../../.cache/interop');
const INSTALL_TIMEOUT_MS = 10 * 60_000;

/** Folder of an installed client, or the reason why it is not installed. */
export type Installation = { readonly folder: string } | { readonly missing: string };

/** Installs one published client, unless an earlier run has. @throws when the installer fails */
export async function install(kind: ClientKind): Promise<Installation> {
  if (kind === 'python') return installPython(kind);
  const packages = join(CLIENTS, kind, 'packages');
  return {
    folder: await cached(kind, packages, async (folder) => {
      await cp(packages, folder, { recursive: true });
      await npm(folder, 'ci', '--ignore-scripts', '--no-audit', '--no-fund');
      if (kind === 'webbrowser') await npm(folder, 'run', 'bundle');
    }),
  };
}

/** Installs the Python packages of `clients/<name>/requirements.txt`. @throws when the installer fails */
export async function installPython(name: string): Promise<Installation> {
  const version = await run('python3', [
    '-c',
    'import sys, venv, ensurepip; print(sys.version)',
  ]).then(
    ({ stdout }) => stdout.trim(),
    () => undefined,
  );
  if (version === undefined) {
    return {
      missing: 'python3 with venv and pip was not found (Debian: apt install python3-venv)',
    };
  }
  const requirements = join(CLIENTS, name, 'requirements.txt');
  const folder = await cached(
    name,
    requirements,
    async (target) => {
      await run('python3', ['-m', 'venv', target]);
      const pip = ['-m', 'pip', 'install', '--disable-pip-version-check', '-q', '-r', requirements];
      await run(join(target, 'bin/python'), pip, { timeout: INSTALL_TIMEOUT_MS });
    },
    version,
  );
  return { folder };
}

async function npm(folder: string, ...args: string[]): Promise<void> {
  await run('npm', args, { cwd: folder, timeout: INSTALL_TIMEOUT_MS });
}

/**
 * The folder `<name>-<hash of what it is made from>`, made by `make` when it is not there. It is made
 * beside and then renamed, so that a run that was interrupted, or runs at the same time, leaves no half of it.
 */
async function cached(
  name: string,
  source: string,
  make: (folder: string) => Promise<void>,
  salt = process.version,
): Promise<string> {
  const folder = join(CACHE, `${name}-${await hashOf(source, salt)}`);
  if (existsSync(folder)) return folder;
  await mkdir(CACHE, { recursive: true });
  const unfinished = await mkdtemp(join(CACHE, `${name}-unfinished-`));
  try {
    await make(unfinished);
    await rename(unfinished, folder);
  } catch (error) {
    await rm(unfinished, { recursive: true, force: true });
    if (!existsSync(folder)) throw error;
  }
  return folder;
}

async function hashOf(path: string, salt: string): Promise<string> {
  const hash = createHash('sha256').update(salt);
  const stack = [path];
  for (let next = stack.pop(); next !== undefined; next = stack.pop()) {
    const current = next;
    const entries = await readdir(current, { withFileTypes: true }).catch(() => undefined);
    if (entries) {
      stack.push(...entries.map((entry) => join(current, entry.name)).sort());
    } else {
      hash.update(current.slice(CLIENTS.length)).update(await readFile(current));
    }
  }
  return hash.digest('hex').slice(0, 12);
}
