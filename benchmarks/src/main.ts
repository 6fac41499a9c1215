import { join, relative, resolve } from 'node:path';
import { callerFolder, runProgram } from '@ubii/program';
import { describeCommit, describeMachine, loadAverage } from './machine.ts';
import { benchmarkProgram, createOptions } from './options.ts';
import type { Options, RunOptions } from './options.ts';
import { compareRuns } from './report/compare-runs.ts';
import { formatRun } from './report/format-run.ts';
import { faultsOf, type RunResult } from './report/results.ts';
import { readRun, writeRun } from './report/results-file.ts';
import { runWorkloads } from './run.ts';
import { WORKLOADS } from './workloads/index.ts';

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
