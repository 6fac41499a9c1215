import { readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';

import { OPTIONS } from './config.ts';
import type { Config, Option, OptionName } from './config.ts';
import { ConfigError } from './config-error.ts';
import { environmentName, flagName } from './option-names.ts';

/** The text of an option that is set, its place, and the base folder of relative paths. */
interface Given {
  readonly text: string;
  readonly place: string;
  readonly baseDir: string;
}

type GivenOptions = ReadonlyMap<OptionName, Given>;

/** What may follow a switch, which means "on" without it. */
const SWITCH = /^(on|off|true|false|yes|no|1|0)$/i;

const names = Object.keys(OPTIONS) as OptionName[];
const examples: Partial<Record<OptionName, string>> = {
  port: 'Use --port 8080, or --port 0 for any free port',
  host: 'Use --host 127.0.0.1, or --lan for all networks',
  legacyPorts: 'Use --legacy-ports off to disable them',
  printEndpoints: 'Use --print-endpoints json',
  allowedOrigins: 'Use * to allow every page',
};

/**
 * Reads the configuration. A flag has precedence over the environment, the environment over the file, and
 * the file over the default.
 *
 * @param args command line without program and script
 * @throws ConfigError for an unknown flag or key and for an invalid value
 */
export function resolveConfig(
  args: readonly string[],
  env: Readonly<Record<string, string | undefined>>,
  cwd: string,
): Config {
  const flags = readFlags(args, cwd);
  const variables = readEnvironment(env, cwd);
  const file = flags.get('config') ?? variables.get('config');
  const options =
    file === undefined
      ? new Map([...variables, ...flags])
      : new Map([...readFile(valueOf('config', file), file.place), ...variables, ...flags]);

  const values = Object.fromEntries(
    names.map((name) => {
      const given = options.get(name);
      return [name, given === undefined ? OPTIONS[name].fallback : valueOf(name, given)];
    }),
  );
  const config = { ...values, given: new Set(options.keys()) } as unknown as Config;
  checkTogether(config, options);
  // Who says where to listen does not want all networks.
  return options.has('host') ? { ...config, lan: false } : config;
}

function readFlags(args: readonly string[], cwd: string): GivenOptions {
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
    else if (OPTIONS[name].placeholder === undefined) text = 'true';
    else if (OPTIONS[name].placeholder?.startsWith('[')) {
      text = SWITCH.test(args[index + 1] ?? '') ? args[(index += 1)] : 'true';
    } else text = args[(index += 1)];
    if (text === undefined || (text.startsWith('--') && argument === flag && text !== 'true')) {
      throw new ConfigError(
        `The flag ${flag} needs a value: ${flag} ${OPTIONS[name].placeholder}. ${OPTIONS[name].description}`,
      );
    }
    given.set(name, { text, place: 'on the command line', baseDir: cwd });
  }
  return given;
}

function readEnvironment(
  env: Readonly<Record<string, string | undefined>>,
  cwd: string,
): GivenOptions {
  const given = new Map<OptionName, Given>();
  for (const name of names) {
    const text = env[environmentName(name)];
    if (text === undefined || text === '') continue;
    given.set(name, {
      text,
      place: `in the environment variable ${environmentName(name)}`,
      baseDir: cwd,
    });
  }
  return given;
}

function readFile(path: string | undefined, place: string): GivenOptions {
  const file = String(path);
  let content: unknown;
  try {
    content = JSON.parse(readFileSync(file, 'utf8'));
  } catch (error) {
    throw new ConfigError(
      `The file given by --config (${place}), ${file}, must be readable and contain JSON: ${messageOf(error)}. Correct the file or remove --config.`,
    );
  }
  if (typeof content !== 'object' || content === null || Array.isArray(content)) {
    throw new ConfigError(
      `The config file ${file} must contain one JSON object, such as { "port": 9000 }.`,
    );
  }
  const given = new Map<OptionName, Given>();
  for (const [key, value] of Object.entries(content)) {
    const name = names.find((candidate) => candidate === key && candidate !== 'config');
    if (name === undefined) {
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
    given.set(name, {
      text: Array.isArray(value) ? value.join(',') : String(value),
      place: `in the config file ${file}`,
      baseDir: dirname(resolve(file)),
    });
  }
  return given;
}

function valueOf<O extends OptionName>(name: O, given: Given): Config[O] {
  const { parse, placeholder } = OPTIONS[name] as Option<unknown>;
  try {
    return parse(given.text, given.baseDir) as Config[O];
  } catch (error) {
    const hint = examples[name] ?? (placeholder && `Use ${flagName(name)} ${placeholder}`);
    throw new ConfigError(
      `The option ${flagName(name)} must be ${messageOf(error)}, but is "${given.text}" ${given.place}${hint ? `. ${hint}` : ''}.`,
    );
  }
}

/** Checks combinations of options. */
function checkTogether(config: Config, options: GivenOptions): void {
  if (config.lan && options.has('lan') && options.has('host')) {
    throw new ConfigError(
      `--lan listens on all networks and --host on "${config.host}" only. Remove one of them.`,
    );
  }
  if (config.trustLoopback && config.loopback === 'none') {
    throw new ConfigError(
      '--trust-loopback makes callers of this machine admins, and --loopback none gives them no access. Remove one of them.',
    );
  }
  if ((config.tlsCertificate === undefined) !== (config.tlsKey === undefined)) {
    throw new ConfigError(
      'A certificate and its key belong together: give both --tls-certificate and --tls-key, or neither.',
    );
  }
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message.replace(/\.$/, '') : String(error);
}
