import { join, relative, resolve } from 'node:path';
import { describeCommit, describeMachine, loadAverage } from './machine.ts';
import { helpText, parseOptions, UsageError, type RunOptions } from './options.ts';
import { compareRuns } from './report/compare-runs.ts';
import { formatRun } from './report/format-run.ts';
import { faultsOf, type RunResult } from './report/results.ts';
import { readRun, writeRun } from './report/results-file.ts';
import { runWorkloads } from './run.ts';
import { WORKLOADS } from './workloads/index.ts';

const GROUPS = [...new Set(WORKLOADS.map(({ group }) => group))];
const RESULTS_DIR = join(import.meta.dirname, '..', 'results');

/** A path as the caller means it: npm runs scripts in the directory of the package. */
function fromCaller(path: string): string {
  return resolve(process.env['INIT_CWD'] ?? process.cwd(), path);
}

async function main(): Promise<number> {
  const options = parseOptions(process.argv.slice(2), GROUPS);
  switch (options.command) {
    case 'help':
      console.log(helpText(GROUPS));
      return 0;
    case 'compare':
      console.log(
        compareRuns(
          await readRun(fromCaller(options.before)),
          await readRun(fromCaller(options.after)),
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
  const paths = {
    master: options.master && fromCaller(options.master),
    profileDir: options.profileDir && fromCaller(options.profileDir),
  };
  const results = await runWorkloads(workloads, { ...options, ...paths }, (line) =>
    console.error(line),
  );
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
  const file = options.out
    ? fromCaller(options.out)
    : join(RESULTS_DIR, `${startedAt.replaceAll(':', '-')}.json`);
  await writeRun(file, result);
  console.log(`\n${formatRun(result)}\n\nWritten to ${relative(fromCaller('.'), file)}`);
  return faultsOf(result).length > 0 ? 1 : 0;
}

try {
  process.exitCode = await main();
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = error instanceof UsageError ? 2 : 1;
}
