import { readFileSync } from 'node:fs';

/** Length of a clock tick in /proc/<pid>/stat: USER_HZ is 100 on every Linux that Node runs on. */
const TICK_US = 10_000;

/** Fields after the command's closing bracket, where utime and stime are (proc(5), 14 and 15). */
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
