import { parseArgs } from 'node:util';
import { readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';

import {
  ConfigError,
  flagName,
  environmentName,
  type Option,
  type OptionTable,
  type OptionValues,
  type ProgramOptions,
} from './option.ts';

/** The text of an option that is set, its place, and the base folder of relative paths. */
interface Given {
  readonly text: string;
  /** Such as `on the command line`. */
  readonly place: string;
  readonly baseDir: string;
}

/** Options that are set, by name. */
type GivenOptions = ReadonlyMap<string, Given>;

/** Values that may follow a switch, which is "on" without one. */
const SWITCH = /^(on|off|true|false|yes|no|1|0)$/i;
const SEE_HELP = 'Use --help to list all flags.';

/** A command line, taken apart. */
interface ReadFlags {
  readonly flags: GivenOptions;
  /** Arguments that are no flags. */
  readonly words: readonly string[];
}

/** @throws ConfigError for an unknown flag, and for a flag without its value */
function readFlags(options: OptionTable, args: readonly string[], cwd: string): ReadFlags {
  const names = new Map(Object.keys(options).map((name) => [flagName(name), name]));
  const { tokens } = parseArgs({
    args: [...args],
    options: Object.fromEntries(
      [...names].map(([flag, name]) => [flag.slice(2), { type: typeOf(options[name]!) }]),
    ),
    // Its own errors do not say what to do.
    strict: false,
    allowPositionals: true,
    tokens: true,
  });
  const flags = new Map<string, Given>();
  const words: string[] = [];
  for (let index = 0; index < tokens.length; index += 1) {
    const token = tokens[index]!;
    if (token.kind === 'positional') words.push(token.value);
    if (token.kind !== 'option') continue;
    const name = names.get(token.rawName);
    if (name === undefined) {
      throw new ConfigError(`Unknown flag ${args[token.index]!.split('=', 1)[0]}. ${SEE_HELP}`);
    }
    let text = token.value;
    if (text === undefined && typeOf(options[name]!) === 'boolean') {
      const next = tokens[index + 1];
      const isValue =
        options[name]!.placeholder !== undefined &&
        next?.kind === 'positional' &&
        SWITCH.test(next.value);
      text = isValue ? next.value : 'true';
      if (isValue) index += 1;
    }
    if (text === undefined || (text.startsWith('--') && !token.inlineValue)) {
      const { placeholder, description } = options[name]!;
      const flag = token.rawName;
      throw new ConfigError(
        `The flag ${flag} needs a value: ${flag} ${placeholder}. ${description}`,
      );
    }
    flags.set(name, { text, place: 'on the command line', baseDir: cwd });
  }
  return { flags, words };
}

/** @throws ConfigError when there are words */
function refuseWords([word]: readonly string[]): void {
  if (word !== undefined) throw new ConfigError(`Unexpected argument "${word}". ${SEE_HELP}`);
}

function typeOf({ placeholder }: Option<unknown>): 'boolean' | 'string' {
  return placeholder === undefined || placeholder.startsWith('[') ? 'boolean' : 'string';
}

/**
 * Reads options from a file with one JSON object.
 *
 * @param file its path
 * @param place of the option that names the file
 * @param fileOption name of that option
 * @param names of all options
 * @throws ConfigError for a file that cannot be read, and for an unknown key
 */
function readConfigFile(
  file: string,
  place: string,
  fileOption: string,
  names: readonly string[],
): GivenOptions {
  const given = new Map<string, Given>();
  for (const [key, value] of Object.entries(readObject(file, place, flagName(fileOption)))) {
    if (key === fileOption || !names.includes(key)) {
      throw new ConfigError(
        `The config file ${file} has the key "${key}", which is not an option. Use --help to list all options.`,
      );
    }
    if (value === null) continue;
    if (typeof value === 'object' && !Array.isArray(value)) {
      throw new ConfigError(
        `The key "${key}" in the config file ${file} must be a text, a number, true, false or a list, but is an object.`,
      );
    }
    given.set(key, {
      text: Array.isArray(value) ? value.join(',') : String(value),
      place: `in the config file ${file}`,
      baseDir: dirname(resolve(file)),
    });
  }
  return given;
}

function readObject(file: string, place: string, flag: string): object {
  let content: unknown;
  try {
    content = JSON.parse(readFileSync(file, 'utf8'));
  } catch (error) {
    const reason = (error as Error).message.replace(/\.$/, '');
    throw new ConfigError(
      `The file given by ${flag} (${place}), ${file}, must be readable and contain JSON: ${reason}. Correct the file or remove ${flag}.`,
    );
  }
  if (typeof content !== 'object' || content === null || Array.isArray(content)) {
    throw new ConfigError(
      `The config file ${file} must contain one JSON object, such as { "port": 9000 }.`,
    );
  }
  return content;
}

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
