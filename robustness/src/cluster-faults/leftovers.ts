import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { NetworkNamespaces } from './network/namespace-network.ts';

/*
 * Names of what a run makes contain the id of its process. Without a process of that id, it was left by a run that was
 * killed, and the next run removes it.
 */

const FOLDER = /^ubii-cluster-(\d+)-/;

/** Makes the folder in which masters and NATS of this run store everything. */
export function makeRunFolder(): string {
  const folder = mkdtempSync(join(tmpdir(), `ubii-cluster-${process.pid}-`));
  process.once('exit', () => removeFolder(folder));
  return folder;
}

/** Removes processes, namespaces and folders of runs that were killed. @returns what was removed, in words */
export function removeLeftovers(): string[] {
  return [...removeNetworks(), ...removeFolders()];
}

function removeNetworks(): string[] {
  const left = NetworkNamespaces.all().filter(({ owner }) => !isRunning(owner));
  for (const { name } of left) NetworkNamespaces.remove(name);
  return left.map(({ name }) => `network namespace ${name}`);
}

function removeFolders(): string[] {
  const left = readdirSync(tmpdir()).filter((name) => {
    const owner = FOLDER.exec(name)?.[1];
    return owner !== undefined && !isRunning(Number(owner));
  });
  return left.flatMap((name) => {
    const folder = join(tmpdir(), name);
    const pids = usersOf(folder);
    for (const pid of pids) kill(pid);
    removeFolder(folder);
    return [...pids.map((pid) => `process ${pid}`), `folder ${folder}`];
  });
}

function removeFolder(folder: string): void {
  try {
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  } catch {
    // A process that was killed has not ended yet. The next run finds the rest.
  }
}

/** Processes that were started with a path in this folder. */
function usersOf(folder: string): number[] {
  // Only Linux has namespaces to leave behind, and lists processes as files.
  if (process.platform !== 'linux') return [];
  return readdirSync('/proc')
    .filter((name) => /^\d+$/.test(name))
    .map(Number)
    .filter((pid) => pid > 1 && pid !== process.pid && commandOf(pid).includes(`${folder}/`));
}

function commandOf(pid: number): string {
  try {
    return readFileSync(`/proc/${pid}/cmdline`, 'utf8');
  } catch {
    // It has ended.
    return '';
  }
}

function kill(pid: number): void {
  try {
    process.kill(pid, 'SIGKILL');
  } catch {
    // It has ended.
  }
}

function isRunning(pid: number): boolean {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return (error as NodeJS.ErrnoException).code === 'EPERM';
  }
}
