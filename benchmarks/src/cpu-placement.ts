import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

/**
 * Where broker and load generator run: together on one core, or each on a core of its own. Left to
 * itself the system sometimes does the one and sometimes the other, for seconds.
 */
export type Placement = 'one-core' | 'core-each';

/** The cores this process was started on, as `taskset` writes them: `0-1` or `0,2`. */
const ALLOWED_CORES = /^Cpus_allowed_list:\s*(\S+)/m.exec(
  readFileSync('/proc/self/status', 'latin1'),
)?.[1];

/** True when `taskset` (util-linux) is there to place processes with. */
export const CAN_PLACE = ALLOWED_CORES !== undefined && hasTaskset();

/** Moves all threads of both processes; does nothing where there is no `taskset`. */
export function placeProcesses(placement: Placement, loadPid: number, brokerPid: number): void {
  if (!CAN_PLACE) return;
  const first = /^\d+/.exec(ALLOWED_CORES!)![0];
  const last = /\d+$/.exec(ALLOWED_CORES!)![0];
  moveTo(placement === 'one-core' ? last : first, loadPid);
  moveTo(last, brokerPid);
}

function moveTo(core: string, pid: number): void {
  execFileSync('taskset', ['--all-tasks', '--cpu-list', '--pid', core, String(pid)], {
    stdio: 'ignore',
  });
}

function hasTaskset(): boolean {
  try {
    execFileSync('taskset', ['--version'], { stdio: 'ignore' });
    return true;
  } catch {
    return false;
  }
}
