import { readdirSync, readFileSync } from 'node:fs';

/** Length of a clock tick in /proc: USER_HZ is 100 on every Linux that Node runs on. */
const TICK_US = 10_000;

/** Fields after the command's closing bracket: the parent, utime and stime (proc(5), 4, 14 and 15). */
const PPID_INDEX = 1;
const UTIME_INDEX = 11;
const STIME_INDEX = 12;

/**
 * CPU time a process has used so far, user and system, all threads, microseconds.
 * Resolution 10 ms.
 */
export function processCpuUs(pid: number): number {
  const stat = readFileSync(`/proc/${pid}/stat`, 'latin1');
  const fields = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
  return (Number(fields[UTIME_INDEX]) + Number(fields[STIME_INDEX])) * TICK_US;
}

/** Processes that a process has started, and those they have started. */
export function descendantPids(root: number): number[] {
  const children = new Map<number, number[]>();
  for (const entry of readdirSync('/proc')) {
    const pid = Number(entry);
    if (!Number.isInteger(pid)) continue;
    const parent = parentOf(pid);
    if (parent !== undefined) children.set(parent, [...(children.get(parent) ?? []), pid]);
  }
  const found: number[] = [];
  const visit = (pid: number): void => {
    for (const child of children.get(pid) ?? []) {
      found.push(child);
      visit(child);
    }
  };
  visit(root);
  return found;
}

/** Undefined when the process is over. */
function parentOf(pid: number): number | undefined {
  try {
    const stat = readFileSync(`/proc/${pid}/stat`, 'latin1');
    return Number(stat.slice(stat.lastIndexOf(')') + 2).split(' ')[PPID_INDEX]);
  } catch {
    return undefined;
  }
}

/**
 * CPU time that the main thread of a process has used so far, user and system, microseconds, with
 * fractions. @param pid this process by default
 */
export function mainThreadCpuUs(pid = process.pid): number {
  const schedstat = readFileSync(`/proc/${pid}/task/${pid}/schedstat`, 'latin1');
  return Number(schedstat.split(' ', 1)[0]) / 1000;
}

/** Fields of the first line of /proc/stat that count work (proc(5)); the fourth and fifth are idleness. */
const BUSY_FIELDS = [1, 2, 3, 6, 7, 8];

/** CPU time that all processes have used so far on all cores, microseconds. Resolution 10 ms. */
export function machineCpuUs(): number {
  const fields = readFileSync('/proc/stat', 'latin1').split('\n', 1)[0]!.split(/ +/);
  return BUSY_FIELDS.reduce((sum, index) => sum + Number(fields[index]), 0) * TICK_US;
}
