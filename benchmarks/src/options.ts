import {
  ConfigError,
  HELP_OPTIONS,
  option,
  parseNumber,
  parseWholeNumber,
  pathOption,
  switchOption,
} from '@ubii/program';
import type { ProgramOptions, ReadOptions } from '@ubii/program';

export interface RunOptions {
  readonly command: 'run';
  /** Workload groups to run. */
  readonly groups: readonly string[];
  readonly rounds: number;
  readonly warmUpMs: number;
  readonly measureMs: number;
  /** Total time limit for waiting until other processes are quiet. */
  readonly waitMs: number;
  /** Path of the JSON report; undefined: `benchmarks/results/<time>.json`. */
  readonly out: string | undefined;
  /** Main file of the master to measure; undefined: the one that is built here. */
  readonly master: string | undefined;
  /** Directory for CPU profiles of the brokers. */
  readonly profileDir: string | undefined;
}

export type Options =
  | RunOptions
  | { readonly command: 'compare'; readonly before: string; readonly after: string };

const DEFAULTS = { rounds: 15, measureMs: 600, warmUpMs: 300 };
const QUICK = { rounds: 3, measureMs: 500, warmUpMs: 200 };

const OPTIONS = {
  quick: switchOption(
    `${QUICK.rounds} rounds of ${QUICK.measureMs / 1000} s: to check that it works; the figures do not count.`,
  ),
  rounds: option<number | undefined>({
    placeholder: '<number>',
    fallback: undefined,
    fallbackText: String(DEFAULTS.rounds),
    description:
      'Measurements of each target, interleaved; the median counts. Workloads with modules take a third or a fifth of them.',
    // Fewer have no median worth the name.
    parse: parseWholeNumber(3, 50),
  }),
  seconds: option<number | undefined>({
    placeholder: '<number>',
    fallback: undefined,
    fallbackText: String(DEFAULTS.measureMs / 1000),
    description: 'Duration of one measurement.',
    parse: parseNumber(0.1, 60),
  }),
  wait: option({
    placeholder: '<seconds>',
    fallback: 0,
    description: 'Maximum total time to wait for other processes before measurements.',
    parse: parseNumber(0, 3600),
  }),
  out: pathOption('<file>', 'benchmarks/results/<time>.json', 'File for the results, as JSON.'),
  master: pathOption(
    '<file>',
    'the one that is built here',
    'Another build of the master, to compare two of them.',
  ),
  profile: pathOption(
    '<folder>',
    'none',
    'Write CPU profiles of the brokers. The figures of such a run do not count.',
  ),
  help: HELP_OPTIONS.help,
};

/** The program with its workload groups. */
export function benchmarkProgram(groups: readonly string[]): ProgramOptions<typeof OPTIONS> {
  return {
    options: OPTIONS,
    takesWords: true,
    errorExitCode: 2,
    about: `Measures the master, and what runs modules, beside the least that does the same in the same run.

  npm run bench                          every workload
  npm run bench -- <workload>…           ${groups.join(', ')}
  npm run bench -- compare <a> <b>       two JSON files of earlier runs
`,
    notes: `Ends with 1 when a record was lost or altered, 2 when the command line is wrong.
How to read the figures: benchmarks/README.md.`,
  };
}

/** @throws ConfigError for words that are neither workloads nor a comparison */
export function createOptions(
  { values, words }: ReadOptions<typeof OPTIONS>,
  groups: readonly string[],
): Options {
  if (words[0] === 'compare') {
    const [, before, after, ...more] = words;
    if (before === undefined || after === undefined || more.length > 0) {
      throw new ConfigError('compare needs two files: npm run bench -- compare <a.json> <b.json>.');
    }
    return { command: 'compare', before, after };
  }
  for (const name of words) {
    if (!groups.includes(name)) {
      const all = new Intl.ListFormat('en-GB').format(groups);
      throw new ConfigError(`There is no workload "${name}"; there are ${all}.`);
    }
  }
  const base = values.quick ? QUICK : DEFAULTS;
  return {
    command: 'run',
    groups: words.length > 0 ? words : groups,
    rounds: values.rounds ?? base.rounds,
    warmUpMs: base.warmUpMs,
    measureMs: values.seconds === undefined ? base.measureMs : 1000 * values.seconds,
    waitMs: 1000 * values.wait,
    out: values.out,
    master: values.master,
    profileDir: values.profile,
  };
}
