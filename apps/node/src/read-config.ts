import { ALL_OPTIONS } from './options.ts';
import type { Config, OptionName } from './options.ts';

/** Invalid configuration. The message is printed as it is, without a stack. */
export class ConfigError extends Error {
  override readonly name = 'ConfigError';
}

interface Given {
  readonly text: string;
  readonly place: string;
}

const names = Object.keys(ALL_OPTIONS) as OptionName[];

/**
 * Reads the configuration. A flag has precedence over the environment, and the environment over the default.
 *
 * @param args arguments without program and script
 * @throws ConfigError for an unknown flag and for an invalid value
 */
export function readConfig(
  args: readonly string[],
  env: Readonly<Record<string, string | undefined>>,
  cwd: string,
): Config {
  const given = new Map([...readEnvironment(env), ...readFlags(args)]);
  const values = names.map((name) => {
    const { fallback, parse, placeholder } = ALL_OPTIONS[name];
    const set = given.get(name);
    if (set === undefined) return [name, fallback];
    try {
      return [name, parse(set.text, cwd)];
    } catch (error) {
      const hint = placeholder === undefined ? '' : `. Use ${flagName(name)} ${placeholder}`;
      throw new ConfigError(
        `The option ${flagName(name)} must be ${(error as Error).message}, but is "${set.text}" ${set.place}${hint}.`,
      );
    }
  });
  const config = Object.fromEntries(values) as unknown as Config;
  if (config.discover && given.has('master')) {
    throw new ConfigError(
      'The options --master and --discover both choose the master. Remove one of them.',
    );
  }
  if (config.join !== undefined && config.tokenFile !== undefined) {
    throw new ConfigError(
      'The options --join and --token-file both set the token. Remove one of them.',
    );
  }
  return config;
}

/** `allowFetch` -> `--allow-fetch` */
export function flagName(name: OptionName): string {
  return `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
}

/** `allowFetch` -> `UBII_NODE_ALLOW_FETCH` */
export function environmentName(name: OptionName): string {
  return `UBII_NODE_${name.replace(/[A-Z]/g, (letter) => `_${letter}`).toUpperCase()}`;
}

function readFlags(args: readonly string[]): Map<OptionName, Given> {
  const given = new Map<OptionName, Given>();
  for (let index = 0; index < args.length; index += 1) {
    const argument = args[index] ?? '';
    const flag = argument.split('=', 1)[0] ?? '';
    const name = names.find((candidate) => flagName(candidate) === flag);
    if (name === undefined) {
      throw new ConfigError(
        argument.startsWith('-')
          ? `Unknown flag ${flag}. Use --help to list all flags.`
          : `Unexpected argument "${argument}". Use --help to list all flags.`,
      );
    }
    let text: string | undefined;
    if (argument.length > flag.length) text = argument.slice(flag.length + 1);
    else if (ALL_OPTIONS[name].placeholder === undefined) text = 'true';
    else text = args[(index += 1)];
    if (text === undefined || (argument === flag && text.startsWith('--'))) {
      throw new ConfigError(
        `The flag ${flag} needs a value: ${flag} ${ALL_OPTIONS[name].placeholder}. ${ALL_OPTIONS[name].description}`,
      );
    }
    given.set(name, { text, place: 'on the command line' });
  }
  return given;
}

function readEnvironment(
  env: Readonly<Record<string, string | undefined>>,
): Map<OptionName, Given> {
  const given = new Map<OptionName, Given>();
  for (const name of names) {
    const text = env[environmentName(name)];
    if (text === undefined || text === '') continue;
    given.set(name, { text, place: `in the environment variable ${environmentName(name)}` });
  }
  return given;
}
