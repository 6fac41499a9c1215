import { ConfigError } from './config-error.ts';
import type { Given, GivenOptions } from './read-flags.ts';
import { environmentName, flagName } from './option.ts';
import type { Option, OptionTable, OptionValues, ProgramOptions } from './option.ts';
import { readConfigFile } from './read-config-file.ts';
import { readFlags, refuseWords } from './read-flags.ts';

/** Environment variables, such as `process.env`. */
export type Environment = Readonly<Record<string, string | undefined>>;

/** Values of the options of a program. */
export interface ReadOptions<O extends OptionTable> {
  readonly values: OptionValues<O>;
  /** Options that are set in any place. */
  readonly given: ReadonlySet<keyof O & string>;
  /** Arguments that are no flags, of programs that take them. */
  readonly words: readonly string[];
}

/**
 * Reads the options of a program from its command line, its environment and its config file.
 *
 * @param args command line without program and script
 * @param cwd folder that paths on the command line and in the environment are relative to
 * @throws ConfigError for an unknown flag or key, an invalid value, and options that contradict each other
 */
export function readOptions<O extends OptionTable>(
  program: ProgramOptions<O>,
  args: readonly string[],
  env: Environment,
  cwd: string,
): ReadOptions<O> {
  const { options, environmentPrefix, fileOption, takesWords = false } = program;
  const names = Object.keys(options);
  const { flags, words } = readFlags(options, args, cwd);
  if (!takesWords) refuseWords(words);
  const given = new Map([...readEnvironment(names, environmentPrefix, env, cwd), ...flags]);
  const file = fileOption === undefined ? undefined : given.get(fileOption);
  if (fileOption !== undefined && file !== undefined) {
    const path = String(valueOf(fileOption, options[fileOption]!, file));
    for (const [name, inFile] of readConfigFile(path, file.place, fileOption, names)) {
      if (!given.has(name)) given.set(name, inFile);
    }
  }
  const entries = names.map((name) => {
    const set = given.get(name);
    return [name, set === undefined ? options[name]!.fallback : valueOf(name, options[name]!, set)];
  });
  const values = Object.fromEntries(entries) as OptionValues<O>;
  program.check?.(values, new Set(given.keys()));
  return { values, given: new Set(given.keys()), words };
}

function readEnvironment(
  names: readonly string[],
  prefix: string | undefined,
  env: Environment,
  cwd: string,
): GivenOptions {
  const given = new Map<string, Given>();
  if (prefix === undefined) return given;
  for (const name of names) {
    const variable = environmentName(prefix, name);
    const text = env[variable];
    if (text === undefined || text === '') continue;
    given.set(name, { text, place: `in the environment variable ${variable}`, baseDir: cwd });
  }
  return given;
}

function valueOf(
  name: string,
  { parse, placeholder, hint, isSecret }: Option<unknown>,
  { text, place, baseDir }: Given,
): unknown {
  try {
    return parse(text, baseDir);
  } catch (error) {
    const flag = flagName(name);
    const advice = hint ?? (placeholder && `Use ${flag} ${placeholder}`);
    const received = isSecret ? 'something else' : `"${text}"`;
    throw new ConfigError(
      `The option ${flag} must be ${(error as Error).message}, but is ${received} ${place}${advice ? `. ${advice}` : ''}.`,
    );
  }
}
