import { readdirSync, readFileSync } from 'node:fs';

/** Figures of a process from Linux. Each is undefined where there is no `/proc`. */
export interface ProcessFigures {
  readonly residentBytes: number | undefined;
  /** The most it ever had resident. */
  readonly peakBytes: number | undefined;
  readonly descriptors: number | undefined;
  readonly threads: number | undefined;
}

export function readProcess(pid: number): ProcessFigures {
  let status = '';
  let descriptors: number | undefined;
  try {
    status = readFileSync(`/proc/${pid}/status`, 'utf8');
    descriptors = readdirSync(`/proc/${pid}/fd`).length;
  } catch {
    // The process has ended, or this is no Linux.
  }
  const figure = (name: string): number | undefined => {
    const digits = new RegExp(`^${name}:\\s+(\\d+)`, 'm').exec(status)?.[1];
    return digits === undefined ? undefined : Number(digits);
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
  };
}

/** Bytes as MiB, for tables. */
export function mib(bytes: number | undefined): string {
  return bytes === undefined ? '?' : `${(bytes / 1024 / 1024).toFixed(1)} MiB`;
}
