import { readdirSync, readFileSync } from 'node:fs';

/** USER_HZ is 100 on every Linux that Node runs on (proc(5)). */
const TICK_MS = 10;

/** Figures of a process from Linux. Each is undefined where there is no `/proc`. */
export interface ProcessFigures {
  readonly residentBytes: number | undefined;
  /** Peak of the resident memory. */
  readonly peakBytes: number | undefined;
  readonly descriptors: number | undefined;
  readonly threads: number | undefined;
  /** CPU time since its start, milliseconds. */
  readonly cpuMs: number | undefined;
}

/** Reads the figures of a process. */
export function readProcess(pid: number): ProcessFigures {
  let status = '';
  let stat = '';
  let descriptors: number | undefined;
  try {
    status = readFileSync(`/proc/${pid}/status`, 'utf8');
    stat = readFileSync(`/proc/${pid}/stat`, 'utf8');
    descriptors = readdirSync(`/proc/${pid}/fd`).length;
  } catch {
    // The process has ended, or this is no Linux.
  }
  const figure = (name: string): number | undefined => {
    const line = status.split('\n').find((text) => text.startsWith(`${name}:`));
    return line === undefined ? undefined : Number.parseInt(line.slice(name.length + 1));
  };
  const kib = (name: string): number | undefined => {
    const value = figure(name);
    return value === undefined ? undefined : value * 1024;
  };
  return {
    residentBytes: kib('VmRSS'),
    peakBytes: kib('VmHWM'),
    descriptors,
    threads: figure('Threads'),
    cpuMs: cpuMsOf(stat),
  };
}

/** Resident memory of a process and of all processes that it started, bytes; 0 where there is no `/proc`. */
export function residentOfTree(pid: number): number {
  let children: number[] = [];
  try {
    const tasks = readdirSync(`/proc/${pid}/task`);
    children = tasks.flatMap((task) =>
      readFileSync(`/proc/${pid}/task/${task}/children`, 'utf8')
        .split(' ')
        .filter((text) => text !== '')
        .map(Number),
    );
  } catch {
    // The process has ended, or this is no Linux.
  }
  const own = readProcess(pid).residentBytes ?? 0;
  return children.reduce((sum, child) => sum + residentOfTree(child), own);
}

/** @param stat as `/proc/<pid>/stat` says it, where the name of the program may have spaces and parentheses */
function cpuMsOf(stat: string): number | undefined {
  if (stat === '') return undefined;
  const fields = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
  return (Number(fields[11]) + Number(fields[12])) * TICK_MS;
}

/** Bytes as MiB, for tables. */
export function mib(bytes: number | undefined): string {
  return bytes === undefined ? '?' : `${(bytes / 1024 / 1024).toFixed(1)} MiB`;
}
