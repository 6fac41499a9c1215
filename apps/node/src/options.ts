import { hostname } from 'node:os';
import { resolve } from 'node:path';

/** One option of the program. */
interface Option<T> {
  /** Placeholder of the value in the help; `undefined` for a switch without a value. */
  readonly placeholder: string | undefined;
  readonly fallback: T;
  /** Shown in the help instead of the fallback. */
  readonly fallbackText?: string;
  /** What it does, with its unit. */
  readonly description: string;
  /** @throws Error whose message is the expected value, to follow "must be" */
  parse(text: string, baseDir: string): T;
}

function option<T>(entry: Option<T>): Option<T> {
  return entry;
}

/** Room for a few modules. */
const LEAST_MEGABYTES = 8;

/**
 * Every option. Flag and environment variable are made from the name: `allowFetch` is `--allow-fetch`
 * and `UBII_NODE_ALLOW_FETCH`. A flag wins over the environment.
 */
export const OPTIONS = {
  master: option({
    placeholder: '<url>',
    fallback: 'http://localhost:8080',
    description: 'Address of the master.',
    parse: parseUrl,
  }),
  discover: option({
    placeholder: undefined,
    fallback: false,
    description:
      'Find the master in the local network (multicast DNS). With several masters, list them and exit.',
    parse: parseSwitch,
  }),
  join: option<string | undefined>({
    placeholder: '<token|code>',
    fallback: undefined,
    fallbackText: 'none',
    description:
      'Token or code to join with, when the master runs on another machine. Needed once: the node stores its identity.',
    parse: parseJoin,
  }),
  tokenFile: option<string | undefined>({
    placeholder: '<file>',
    fallback: undefined,
    fallbackText: 'none',
    description:
      'File with the token to join with, so that the list of processes does not show it. The file admin-token in the data directory of a local master makes this node an admin.',
    parse: (text, baseDir) => resolve(baseDir, text),
  }),
  modules: option<string | undefined>({
    placeholder: '<folder>',
    fallback: undefined,
    fallbackText: 'none',
    description:
      'Folder with modules of your own, as .pm, .js and .mjs files. Their code is trusted. Changes apply at once.',
    parse: (text, baseDir) => resolve(baseDir, text),
  }),
  name: option({
    placeholder: '<text>',
    fallback: `${hostname().split('.')[0] || 'unnamed'} node`,
    description: 'Name of this node, shown to users.',
    parse: parseName,
  }),
  allowFetch: option<readonly string[]>({
    placeholder: '<origin>,...',
    fallback: [],
    fallbackText: 'none',
    description:
      'Origins that modules may read from with the library http, such as https://example.org,http://sensor.local:8000.',
    parse: parseOrigins,
  }),
  noAcceptWork: option({
    placeholder: undefined,
    fallback: false,
    description:
      'Run only modules that a session assigns to this node by name. The master does not choose this node.',
    parse: parseSwitch,
  }),
  capacity: option({
    placeholder: '<number>',
    fallback: 0,
    fallbackText: 'none',
    description:
      'Number of modules this node should run at once. The master uses it to choose a node.',
    parse: parseCount,
  }),
  memory: option({
    placeholder: '<MiB>',
    fallback: 0,
    fallbackText: "a quarter of the machine's memory, at least 256",
    description:
      'Memory of all sandboxed modules on this node, in MiB. Modules of one session get half of it, at most 1024.',
    parse: parseMegabytes,
  }),
  identity: option<string | undefined>({
    placeholder: '<file>|off',
    fallback: undefined,
    fallbackText: 'a file in the home directory, one for each name and master',
    description:
      'File with the identity of this node, so that its next run is the same client. off: each run is a new client.',
    parse: (text, baseDir) => (text === 'off' ? 'off' : resolve(baseDir, text)),
  }),
  printEndpoints: option<'json' | undefined>({
    placeholder: 'json',
    fallback: undefined,
    fallbackText: 'off',
    description:
      'When connected for the first time, write one line of JSON with id, name, master and pid to standard output.',
    parse: parseJson,
  }),
  logLevel: option<LogLevel>({
    placeholder: 'error|warn|info|debug',
    fallback: 'info',
    description: 'The least severe messages to log.',
    parse: parseLevel,
  }),
  help: option({
    placeholder: undefined,
    fallback: false,
    description: 'Show this help and exit.',
    parse: parseSwitch,
  }),
  version: option({
    placeholder: undefined,
    fallback: false,
    description: 'Show the version and exit.',
    parse: parseSwitch,
  }),
} as const;

export type OptionName = keyof typeof OPTIONS;

/** From most to least severe. */
export const LOG_LEVELS = ['error', 'warn', 'info', 'debug'] as const;

export type LogLevel = (typeof LOG_LEVELS)[number];

/** The values of all options. */
export type Config = {
  readonly [O in OptionName]: (typeof OPTIONS)[O] extends Option<infer T> ? T : never;
};

/** The options with a common type, to iterate over them. */
export const ALL_OPTIONS: Readonly<Record<OptionName, Option<unknown>>> = OPTIONS;

/** Returns the token or code. Also accepts the link of a QR code. */
export function parseJoin(text: string): string {
  const token = text.slice(text.indexOf('#') + 1).trim();
  if (!/^[!-~][ -~]{0,199}$/.test(token)) {
    throw new Error('a token or code, or a link that ends with one');
  }
  return token;
}

function parseUrl(text: string): string {
  const url = URL.canParse(text) ? new URL(text) : undefined;
  if (url === undefined || !/^https?:$/.test(url.protocol) || url.pathname !== '/') {
    throw new Error('an http or https URL without a path, such as http://192.168.1.20:8080');
  }
  return url.origin;
}

function parseName(text: string): string {
  const name = text.trim();
  // eslint-disable-next-line no-control-regex -- names are lines that are drawn and logged
  if (name === '' || name.length > 100 || /[\u0000-\u001f\u007f]/.test(name)) {
    throw new Error('1 to 100 characters, without control characters');
  }
  return name;
}

function parseOrigins(text: string): readonly string[] {
  const origins = text
    .split(',')
    .map((origin) => origin.trim())
    .filter((origin) => origin !== '');
  for (const origin of origins) {
    const url = URL.canParse(origin) ? new URL(origin) : undefined;
    if (url === undefined || !/^https?:$/.test(url.protocol) || url.pathname !== '/') {
      throw new Error('origins separated by commas, such as https://example.org');
    }
  }
  return origins.map((origin) => new URL(origin).origin);
}

function parseSwitch(text: string): boolean {
  if (/^(1|true|on|yes)$/i.test(text)) return true;
  if (/^(0|false|off|no|)$/i.test(text)) return false;
  throw new Error('true or false');
}

function parseCount(text: string): number {
  if (!/^\d{1,5}$/.test(text)) throw new Error('a whole number');
  return Number(text);
}

/** @returns bytes */
function parseMegabytes(text: string): number {
  const megabytes = /^\d{1,6}$/.test(text) ? Number(text) : 0;
  if (megabytes < LEAST_MEGABYTES) throw new Error(`a whole number of MiB from ${LEAST_MEGABYTES}`);
  return megabytes * 1024 * 1024;
}

function parseJson(text: string): 'json' {
  if (text === 'json') return 'json';
  throw new Error('json');
}

function parseLevel(text: string): LogLevel {
  const level = LOG_LEVELS.find((candidate) => candidate === text.toLowerCase());
  if (level === undefined) throw new Error('error, warn, info or debug');
  return level;
}
