import { execFileSync } from 'node:child_process';
import { cpus, loadavg } from 'node:os';
import { join, relative, resolve } from 'node:path';

import { callerFolder, runProgram } from '@ubii/program';

import { CAN_PLACE } from './cpu-placement.ts';
import { benchmarkProgram, createOptions, type Options, type RunOptions } from './options.ts';
import { compareRuns, formatRun } from './report/format-results.ts';
import { readRun, writeRun, faultsOf, type RunResult } from './report/results.ts';
import { runWorkloads } from './run.ts';
import { WORKLOADS } from './workloads/index.ts';

/** Load average of the last minute, two decimals. */
function loadAverage(): number {
  return Math.round((loadavg()[0] ?? 0) * 100) / 100;
}

/** Properties of the machine that influence the figures. */
function describeMachine(loadBefore: number): RunResult['machine'] {
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
function describeCommit(): RunResult['commit'] {
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

const GROUPS = [...new Set(WORKLOADS.map(({ group }) => group))];
const RESULTS_DIR = join(import.meta.dirname, '..', 'results');

async function main(options: Options): Promise<number> {
  switch (options.command) {
    case 'compare':
      console.log(
        compareRuns(
          await readRun(resolve(callerFolder(), options.before)),
          await readRun(resolve(callerFolder(), options.after)),
        ),
      );
      return 0;
    case 'run':
      return run(options);
  }
}

async function run(options: RunOptions): Promise<number> {
  const loadBefore = loadAverage();
  const startedAt = new Date().toISOString();
  const workloads = WORKLOADS.filter((workload) => {
    if (!options.groups.includes(workload.group)) return false;
    const whyNot = workload.whyNot?.();
    if (whyNot !== undefined) console.error(`${workload.name} is left out: ${whyNot}`);
    return whyNot === undefined;
  });
  const results = await runWorkloads(workloads, options, (line) => console.error(line));
  const result: RunResult = {
    formatVersion: 1,
    startedAt,
    machine: describeMachine(loadBefore),
    commit: describeCommit(),
    parameters: {
      rounds: options.rounds,
      warmUpMs: options.warmUpMs,
      measureMs: options.measureMs,
    },
    workloads: results,
  };
  const file = options.out ?? join(RESULTS_DIR, `${startedAt.replaceAll(':', '-')}.json`);
  await writeRun(file, result);
  console.log(`\n${formatRun(result)}\n\nWritten to ${relative(callerFolder(), file)}`);
  return faultsOf(result).length > 0 ? 1 : 0;
}

try {
  await runProgram(
    benchmarkProgram(GROUPS),
    async (read) => {
      process.exitCode = await main(createOptions(read, GROUPS));
    },
    { cwd: callerFolder() },
  );
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}
