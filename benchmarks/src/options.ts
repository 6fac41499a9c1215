import { parseArgs } from 'node:util';

/** A command line that cannot be understood; the message is one sentence for the user. */
export class UsageError extends Error {}

export interface RunOptions {
  readonly command: 'run';
  /** Workload groups to run. */
  readonly groups: readonly string[];
  readonly rounds: number;
  readonly warmUpMs: number;
  readonly measureMs: number;
  /** How long, in all, the run may wait for other processes to be quiet. */
  readonly waitMs: number;
  /** Where the JSON goes; undefined: `benchmarks/results/<time>.json`. */
  readonly out: string | undefined;
  /** Main file of the master to measure; undefined: the one that is built here. */
  readonly master: string | undefined;
  /** Directory for CPU profiles of the brokers. */
  readonly profileDir: string | undefined;
}

export type Options =
  | RunOptions
  | { readonly command: 'help' }
  | { readonly command: 'compare'; readonly before: string; readonly after: string };

const DEFAULTS = { rounds: 15, measureMs: 600, warmUpMs: 300 };
const QUICK = { rounds: 3, measureMs: 500, warmUpMs: 200 };
/** Fewer have no median worth the name. */
const MIN_ROUNDS = 3;
const MAX_ROUNDS = 50;
const MIN_SECONDS = 0.1;
const MAX_SECONDS = 60;
const MAX_WAIT_SECONDS = 3600;

/** The text of `--help`. */
export function helpText(groups: readonly string[]): string {
  return `Measures the master, and what runs modules, beside the least that does the same in the same run.

  npm run bench                          every workload
  npm run bench -- <workload>…           ${groups.join(', ')}
  npm run bench -- compare <a> <b>       two JSON files of earlier runs

  --quick            ${QUICK.rounds} rounds of ${QUICK.measureMs / 1000} s: to see that it works, not to judge by
  --rounds <n>       measurements of each target, interleaved; the median counts (default ${DEFAULTS.rounds}, at least ${MIN_ROUNDS});
                     workloads with modules take a third or a fifth of them
  --seconds <s>      length of one measurement (default ${DEFAULTS.measureMs / 1000})
  --wait <s>         wait for other processes before a measurement, in all so long (default 0)
  --out <file>       where the JSON goes (default benchmarks/results/<time>.json)
  --master <file>    another build of the master, to compare two of them
  --profile <dir>    write CPU profiles of the brokers; the figures of such a run do not count
  --help             this text

Ends with 1 when a record was lost or altered, 2 when the command line is wrong.
How to read the figures: benchmarks/README.md.`;
}

/** @throws UsageError */
export function parseOptions(args: readonly string[], groups: readonly string[]): Options {
  const { values, positionals } = parse(args);
  if (values.help) return { command: 'help' };
  if (positionals[0] === 'compare') {
    const [, before, after, ...more] = positionals;
    if (before === undefined || after === undefined || more.length > 0) {
      throw new UsageError('compare needs two files: npm run bench -- compare <a.json> <b.json>.');
    }
    return { command: 'compare', before, after };
  }
  for (const name of positionals) {
    if (!groups.includes(name)) {
      throw new UsageError(`There is no workload "${name}"; there are ${groups.join(' and ')}.`);
    }
  }
  const base = values.quick ? QUICK : DEFAULTS;
  return {
    command: 'run',
    groups: positionals.length > 0 ? positionals : groups,
    rounds: numberOf('--rounds', values.rounds, base.rounds, MIN_ROUNDS, MAX_ROUNDS, true),
    warmUpMs: base.warmUpMs,
    measureMs:
      1000 *
      numberOf('--seconds', values.seconds, base.measureMs / 1000, MIN_SECONDS, MAX_SECONDS, false),
    waitMs: 1000 * numberOf('--wait', values.wait, 0, 0, MAX_WAIT_SECONDS, false),
    out: values.out,
    master: values.master,
    profileDir: values.profile,
  };
}

function parse(args: readonly string[]) {
  try {
    return parseArgs({
      args: [...args],
      allowPositionals: true,
      options: {
        help: { type: 'boolean', short: 'h' },
        quick: { type: 'boolean' },
        rounds: { type: 'string' },
        seconds: { type: 'string' },
        wait: { type: 'string' },
        out: { type: 'string' },
        master: { type: 'string' },
        profile: { type: 'string' },
      },
    });
  } catch (error) {
    throw new UsageError(`${(error as Error).message.split('. ')[0]}. See --help.`);
  }
}

function numberOf(
  flag: string,
  text: string | undefined,
  preset: number,
  min: number,
  max: number,
  isWhole: boolean,
): number {
  if (text === undefined) return preset;
  const value = Number(text);
  if (text.trim() === '' || !(value >= min && value <= max) || (isWhole && value % 1 !== 0)) {
    const kind = isWhole ? 'whole number' : 'number';
    throw new UsageError(`${flag} needs a ${kind} from ${min} to ${max}, received "${text}".`);
  }
  return value;
}
