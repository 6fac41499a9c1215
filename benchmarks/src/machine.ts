import { execFileSync } from 'node:child_process';
import { cpus, loadavg } from 'node:os';
import { CAN_PLACE } from './cpu-placement.ts';
import type { RunResult } from './report/results.ts';

/** Load average of the last minute, two decimals. */
export function loadAverage(): number {
  return Math.round((loadavg()[0] ?? 0) * 100) / 100;
}

/** Properties of the machine that influence the figures. */
export function describeMachine(loadBefore: number): RunResult['machine'] {
  const processors = cpus();
  return {
    node: process.versions.node,
    cores: processors.length,
    cpu: processors[0]?.model ?? 'unknown',
    loadAverage: [loadBefore, loadAverage()],
    isPlaced: CAN_PLACE,
  };
}

/** The commit that was measured; `unknown` outside a repository. */
export function describeCommit(): RunResult['commit'] {
  try {
    const git = (...args: string[]): string =>
      execFileSync('git', args, { cwd: import.meta.dirname, encoding: 'utf8' }).trim();
    return {
      hash: git('rev-parse', 'HEAD'),
      isDirty: git('status', '--porcelain', '--untracked-files=no') !== '',
    };
  } catch {
    return { hash: 'unknown', isDirty: false };
  }
}
