import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { ClusterNetwork } from './ground/cluster-network.ts';

/*
 * What a run makes has the id of its process in its name. Who finds such a name while no process has that id removes
 * what an earlier run left that was killed.
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
  const left = ClusterNetwork.all().filter(({ owner }) => !isRunning(owner));
  for (const { name } of left) ClusterNetwork.remove(name);
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
  if (process.platform === 'win32') return [];
  const lines = execFileSync('ps', ['-A', '-ww', '-o', 'pid=,args='], { encoding: 'utf8' });
  return lines
    .split('\n')
    .filter((line) => line.includes(`${folder}/`))
    .map((line) => Number.parseInt(line, 10))
    .filter((pid) => pid > 1 && pid !== process.pid);
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
