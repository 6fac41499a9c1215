import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

/**
 * CPU cores of the measured processes and the load generator: all on one core, the load generator on one and all others
 * on another, or chosen by the system. Left to itself the system alternates between the first two, for seconds at a
 * time.
 */
export type Placement = 'one-core' | 'core-each' | 'anywhere';

/** The cores this process was started on, as `taskset` writes them: `0-1` or `0,2`. */
const ALLOWED_CORES = /^Cpus_allowed_list:\s*(\S+)/m.exec(
  readFileSync('/proc/self/status', 'latin1'),
)?.[1];

/** True when `taskset` (util-linux) is there to place processes with. */
export const CAN_PLACE = ALLOWED_CORES !== undefined && hasTaskset();

/** Moves all threads of these processes; does nothing where there is no `taskset`. */
export function placeProcesses(
  placement: Placement,
  loadPid: number,
  pids: readonly number[],
): void {
  if (!CAN_PLACE) return;
  const first = /^\d+/.exec(ALLOWED_CORES!)![0];
  const last = /\d+$/.exec(ALLOWED_CORES!)![0];
  const cores = {
    'one-core': [last, last],
    'core-each': [first, last],
    anywhere: [ALLOWED_CORES!, ALLOWED_CORES!],
  } as const;
  const [ofLoad, ofOthers] = cores[placement];
  moveTo(ofLoad, loadPid);
  for (const pid of pids) moveTo(ofOthers, pid);
}

function moveTo(cores: string, pid: number): void {
  execFileSync('taskset', ['--all-tasks', '--cpu-list', '--pid', cores, String(pid)], {
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
