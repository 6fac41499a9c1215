import { hostname } from 'node:os';

import { defaultDataDir } from './default-data-dir.ts';
import { ORIGINAL_PORTS, type LegacyPorts } from './legacy-ports.ts';
import {
  parseChoice,
  parseFetchOrigins,
  parseFilePath,
  parseHost,
  parseLegacyPorts,
  parseLimits,
  parseMirror,
  parseName,
  parseNetworks,
  parseOrigins,
  parsePercent,
  parsePort,
  parseSwitch,
} from './parse-values.ts';

import { DEFAULT_CHECKS, type CheckSettings } from '../../core/checks/check-settings.ts';
import type { Limits } from '../../core/limits/index.ts';

/** One option of the master. */
export interface Option<T> {
  /** What follows the flag in the help; undefined for a switch that needs no value. */
  readonly placeholder: string | undefined;
  /** Default value. */
  readonly fallback: T;
  /** What the help says about the fallback, where the value itself would say little. */
  readonly fallbackText?: string;
  /** What it does, with its unit. */
  readonly description: string;
  /**
   * @param text as given on the command line, in the environment or in the file
   * @param baseDir folder that relative paths are relative to
   * @throws Error whose message is what was expected, to follow "must be"
   */
  parse(text: string, baseDir: string): T;
}

function option<T>(entry: Option<T>): Option<T> {
  return entry;
}

/**
 * Every option. The flag, the environment variable and the key in the config file are made from the
 * name: `dataDir` is `--data-dir`, `UBII_DATA_DIR` and `"dataDir"`. A flag wins over the environment,
 * the environment over the file, the file over the fallback.
 */
export const OPTIONS = {
  port: option({
    placeholder: '<number>',
    fallback: 8080,
    description: 'Port of the frontend, the services and the topic data; 0 takes any free port.',
    parse: parsePort,
  }),
  host: option({
    placeholder: '<name>',
    fallback: 'localhost',
    fallbackText: 'localhost with --lan off',
    description:
      'Name or address to listen on instead of all networks: localhost accepts programs of this machine only.',
    parse: parseHost,
  }),
  lan: option({
    placeholder: '[on|off]',
    fallback: true,
    fallbackText: 'on',
    description:
      'Listen on all networks of this machine, so that phones can join with the code that the terminal shows. Clients that have not joined have no access. Off with --host.',
    parse: parseSwitch,
  }),
  allowLegacy: option<readonly string[]>({
    placeholder: '<network>,...',
    fallback: [],
    fallbackText: 'none',
    description:
      'Networks whose existing clients are participants without joining, because they do not support codes: 192.168.1.0/24,10.0.0.7. For this machine, see --loopback.',
    parse: parseNetworks,
  }),
  loopback: option<'participant' | 'none'>({
    placeholder: 'participant|none',
    fallback: 'participant',
    description:
      'Role of programs and pages of this machine that send no token: participant, so that existing clients work, or none. The address or code in the terminal makes an admin.',
    parse: parseChoice('participant', 'none'),
  }),
  trustLoopback: option({
    placeholder: '[on|off]',
    fallback: false,
    fallbackText: 'off',
    description:
      'Programs and pages of this machine are admins without a token, as in earlier versions. Use it only on a machine with one user and without a proxy.',
    parse: parseSwitch,
  }),
  trustedProxy: option<readonly string[]>({
    placeholder: '<network>,...',
    fallback: [],
    fallbackText: 'none',
    description:
      'Networks of proxies that name their clients in X-Forwarded-For or Forwarded: 10.0.0.7,192.168.2.0/24. Clients behind any other proxy have to join.',
    parse: parseNetworks,
  }),
  https: option<'on' | 'off'>({
    placeholder: 'on|off',
    fallback: 'on',
    description:
      'HTTPS on the same port as HTTP, when other machines can reach the master. Browsers give sensors and cameras to HTTPS pages only. The master creates its certificates itself.',
    parse: parseChoice('on', 'off'),
  }),
  tlsCertificate: option<string | undefined>({
    placeholder: '<file>',
    fallback: undefined,
    fallbackText: 'its own',
    description: 'Certificate for HTTPS from another authority, with its chain, as PEM.',
    parse: parseFilePath,
  }),
  tlsKey: option<string | undefined>({
    placeholder: '<file>',
    fallback: undefined,
    fallbackText: 'its own',
    description: 'Private key of that certificate, as PEM.',
    parse: parseFilePath,
  }),
  mdns: option<'on' | 'off'>({
    placeholder: 'on|off',
    fallback: 'on',
    description:
      'Announce this master in the local network (_ubii._tcp, multicast DNS), when other machines can reach it, so that programs find it without its address.',
    parse: parseChoice('on', 'off'),
  }),
  dataDir: option({
    placeholder: '<folder>',
    fallback: defaultDataDir(),
    description:
      'Folder for the data that the master keeps between runs. Created when it is missing.',
    parse: parseFilePath,
  }),
  modules: option<string | undefined>({
    placeholder: '<folder>',
    fallback: undefined,
    fallbackText: 'none',
    description:
      'Folder of trusted processing modules (.pm, .js): they run at full speed, with libraries.',
    parse: parseFilePath,
  }),
  allowFetch: option<readonly string[]>({
    placeholder: '<origin>,...',
    fallback: [],
    fallbackText: 'none',
    description:
      'Origins that modules with the library http may read from: https://example.org,http://sensor.local:8000.',
    parse: parseFetchOrigins,
  }),
  modelMirror: option<string | undefined>({
    placeholder: '<url>',
    fallback: undefined,
    fallbackText: 'the publishers',
    description:
      'Where models are downloaded from instead of their publishers, for rooms without internet: a folder as models/ of the data directory, such as http://10.0.0.7/models/. Sizes and hashes are verified all the same.',
    parse: parseMirror,
  }),
  config: option<string | undefined>({
    placeholder: '<file>',
    fallback: undefined,
    fallbackText: 'none',
    description: 'JSON file with options: { "port": 9000, "lan": false }.',
    parse: parseFilePath,
  }),
  legacyPorts: option<LegacyPorts | undefined>({
    placeholder: 'on|off|<services>,<topic data>',
    fallback: ORIGINAL_PORTS,
    fallbackText: 'on: 8102,8104',
    description: 'Ports that existing clients use. By default, a port that is in use is left out.',
    parse: parseLegacyPorts,
  }),
  allowedOrigins: option<readonly string[]>({
    placeholder: '<origin>,...',
    fallback: [],
    fallbackText: 'none',
    description:
      'Web pages of other origins that may call the services, besides those of this machine and, with --lan, of private addresses: https://example.org, https://*.example.org, http://example.org:*, or * for all. Those named, and not *, need not join when this machine shows them over HTTPS, or by an address.',
    parse: parseOrigins,
  }),
  name: option({
    placeholder: '<text>',
    fallback: hostname().split('.')[0] || 'master-node',
    description: 'Name of this master, shown to users.',
    parse: parseName,
  }),
  printEndpoints: option<'json' | undefined>({
    placeholder: 'json',
    fallback: undefined,
    fallbackText: 'off',
    description:
      'When ready, write one line of JSON with the addresses to standard output, for scripts; everything else goes to standard error.',
    parse: parseChoice('json'),
  }),
  checks: option<CheckSettings['checks']>({
    placeholder: 'off|warn|throttle',
    fallback: DEFAULT_CHECKS.checks,
    description:
      'Reaction to overload by a publisher, a module or the master: nothing, a warning, or a warning and a throttle for noisy publishers.',
    parse: parseChoice('off', 'warn', 'throttle'),
  }),
  busyPercent: option({
    placeholder: '<percent>',
    fallback: DEFAULT_CHECKS.busyPercent,
    description: 'Share of the time, in percent, above which the master counts as busy.',
    parse: parsePercent,
  }),
  publisherPercent: option({
    placeholder: '<percent>',
    fallback: DEFAULT_CHECKS.publisherPercent,
    description:
      "Share of the master's time, in percent, that the records of one client may take before it counts as noisy.",
    parse: parsePercent,
  }),
  limits: option<Partial<Limits>>({
    placeholder: '<name>=<number>,...',
    fallback: {},
    fallbackText: 'defaults',
    description:
      'Limits that differ from the defaults: clients=20000,topics=500000. Settings, Limits in the frontend lists all limits with units and reasons.',
    parse: parseLimits,
  }),
  logLevel: option<'error' | 'warn' | 'info' | 'debug'>({
    placeholder: 'error|warn|info|debug',
    fallback: 'info',
    description: 'The least severe messages to log.',
    parse: parseChoice('error', 'warn', 'info', 'debug'),
  }),
  logFormat: option<'auto' | 'text' | 'json'>({
    placeholder: 'auto|text|json',
    fallback: 'auto',
    description:
      'Format of the log on standard error; auto is text on a terminal and JSON lines otherwise.',
    parse: parseChoice('auto', 'text', 'json'),
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

/** The values the master runs with. */
export type Config = {
  readonly [O in OptionName]: (typeof OPTIONS)[O] extends Option<infer T> ? T : never;
} & {
  /** Options that are set in any place. Only options that are not set may change at startup. */
  readonly given: ReadonlySet<OptionName>;
};
