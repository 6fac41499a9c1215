import { parseArgs } from 'node:util';
import { ConfigError } from './config-error.ts';
import { flagName } from './option.ts';
import type { Option, OptionTable } from './option.ts';

/** The text of an option that is set, its place, and the base folder of relative paths. */
export interface Given {
  readonly text: string;
  /** Such as `on the command line`. */
  readonly place: string;
  readonly baseDir: string;
}

/** Options that are set, by name. */
export type GivenOptions = ReadonlyMap<string, Given>;

/** Values that may follow a switch, which is "on" without one. */
const SWITCH = /^(on|off|true|false|yes|no|1|0)$/i;
const SEE_HELP = 'Use --help to list all flags.';

/** A command line, taken apart. */
export interface ReadFlags {
  readonly flags: GivenOptions;
  /** Arguments that are no flags. */
  readonly words: readonly string[];
}

/** @throws ConfigError for an unknown flag, and for a flag without its value */
export function readFlags(options: OptionTable, args: readonly string[], cwd: string): ReadFlags {
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
export function refuseWords([word]: readonly string[]): void {
  if (word !== undefined) throw new ConfigError(`Unexpected argument "${word}". ${SEE_HELP}`);
}

function typeOf({ placeholder }: Option<unknown>): 'boolean' | 'string' {
  return placeholder === undefined || placeholder.startsWith('[') ? 'boolean' : 'string';
}
