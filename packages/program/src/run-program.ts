import { ConfigError } from './config-error.ts';
import { formatHelp } from './format-help.ts';
import type { OptionTable, ProgramOptions } from './option.ts';
import { readOptions } from './read-options.ts';
import type { ReadOptions } from './read-options.ts';

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
