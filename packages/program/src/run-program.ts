import {
  environmentName,
  flagName,
  ConfigError,
  type OptionTable,
  type ProgramOptions,
} from './option.ts';
import { readOptions, type ReadOptions } from './read-options.ts';

const LINE_WIDTH = 96;
const INDENT = '      ';

/** Returns the help: each option with its flag, environment variable, key, default and meaning. */
export function formatHelp({
  options,
  about,
  notes,
  environmentPrefix,
  fileOption,
}: Omit<ProgramOptions<OptionTable>, 'check'>): string {
  const entries = Object.entries(options).map(([name, entry]) => {
    const { placeholder, fallback, fallbackText, description } = entry;
    const flag = `  ${flagName(name)}${placeholder === undefined ? '' : ` ${placeholder}`}`;
    const ways = [
      ...(environmentPrefix === undefined ? [] : [environmentName(environmentPrefix, name)]),
      ...(fileOption === undefined ? [] : [`"${name}"`]),
    ];
    const preset = `default: ${fallbackText ?? String(fallback)}`;
    const last = ways.length === 0 ? preset : `${ways.join(', ')}; ${preset}`;
    return [flag, ...wrap(description), ...wrap(last)].join('\n');
  });
  return [about, ...entries, ...(notes === undefined ? [] : ['', notes]), ''].join('\n');
}

function wrap(text: string): string[] {
  const lines: string[] = [];
  let line = INDENT;
  for (const word of text.split(' ')) {
    if (line.length + word.length > LINE_WIDTH) {
      lines.push(line.trimEnd());
      line = INDENT;
    }
    line += `${word} `;
  }
  return [...lines, line.trimEnd()];
}

/**
 * Runs a program: prints the help or the version when the command line asks for it, and otherwise calls `main` with the
 * options. After a `ConfigError`, prints its message and exits.
 *
 * @param version Default: the program has no option `version`
 * @param cwd folder that paths on the command line are relative to. Default: that of the process
 */
export async function runProgram<O extends OptionTable>(
  program: ProgramOptions<O>,
  main: (options: ReadOptions<O>) => void | Promise<void>,
  { version, cwd = process.cwd() }: { readonly version?: string; readonly cwd?: string } = {},
): Promise<void> {
  const args = process.argv.slice(2);
  await exitOnConfigError(async () => {
    if (asksForHelp(args)) {
      process.stdout.write(formatHelp(program));
      return;
    }
    const options = readOptions(program, args, process.env, cwd);
    if (version !== undefined && 'version' in options.values && options.values.version === true) {
      process.stdout.write(`${version}\n`);
      return;
    }
    await main(options);
  }, program.errorExitCode);
}

/** Whether a command line has `--help` or `-h`. The help is also printed beside invalid flags. */
export function asksForHelp(args: readonly string[]): boolean {
  return args.includes('--help') || args.includes('-h');
}

/** After a `ConfigError` of `work`, prints its message and exits. Other errors are passed on. */
export async function exitOnConfigError(work: () => Promise<void>, exitCode = 1): Promise<void> {
  try {
    await work();
  } catch (error) {
    if (!(error instanceof ConfigError)) throw error;
    process.stderr.write(`${error.message}\n`);
    process.exit(exitCode);
  }
}
