import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

/** Where broker and load generator run: together on one core, or wherever the system puts them. */
export type Placement = 'one-core' | 'any-core';

/** The cores this process was started on, as `taskset` writes them: `0-1` or `0,2`. */
const ALLOWED_CORES = /^Cpus_allowed_list:\s*(\S+)/m.exec(
  readFileSync('/proc/self/status', 'latin1'),
)?.[1];

/** True when `taskset` (util-linux) is there to place processes with. */
export const CAN_PLACE = ALLOWED_CORES !== undefined && hasTaskset();

/** Moves all threads of the processes; does nothing where there is no `taskset`. */
export function placeProcesses(placement: Placement, pids: readonly number[]): void {
  if (!CAN_PLACE) return;
  const cores = placement === 'one-core' ? /\d+$/.exec(ALLOWED_CORES!)![0] : ALLOWED_CORES!;
  for (const pid of pids) {
    execFileSync('taskset', ['--all-tasks', '--cpu-list', '--pid', cores, String(pid)], {
      stdio: 'ignore',
    });
  }
}

function hasTaskset(): boolean {
  try {
    execFileSync('taskset', ['--version'], { stdio: 'ignore' });
    return true;
  } catch {
    return false;
  }
}
