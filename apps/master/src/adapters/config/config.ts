import { hostname } from 'node:os';
import {
  HELP_OPTIONS,
  logLevelOption,
  option,
  parseChoice,
  parseFetchOrigins,
  parseName,
  parseNumber,
  parsePath,
  parseSwitch,
  userDataFolder,
} from '@ubii/program';
import type { OptionValues, ProgramOptions } from '@ubii/program';

import { ORIGINAL_PORTS, type LegacyPorts } from './legacy-ports.ts';
import {
  parseHost,
  parseLegacyPorts,
  parseLimits,
  parseMirror,
  parseNetworks,
  parseOrigins,
  parsePort,
} from './parse-values.ts';

import { DEFAULT_CHECKS, type CheckSettings } from '../../core/checks/check-settings.ts';
import type { Limits } from '../../core/limits/index.ts';

/** Every option. */
export const OPTIONS = {
  port: option({
    placeholder: '<number>',
    fallback: 8080,
    description: 'Port of the frontend, the services and the topic data; 0 takes any free port.',
    hint: 'Use --port 8080, or --port 0 for any free port',
    parse: parsePort,
  }),
  host: option({
    placeholder: '<name>',
    fallback: 'localhost',
    fallbackText: 'localhost with --lan off',
    description:
      'Name or address to listen on instead of all networks: localhost accepts programs of this machine only.',
    hint: 'Use --host 127.0.0.1, or --lan for all networks',
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
    parse: parsePath,
  }),
  tlsKey: option<string | undefined>({
    placeholder: '<file>',
    fallback: undefined,
    fallbackText: 'its own',
    description: 'Private key of that certificate, as PEM.',
    isSecret: true,
    parse: parsePath,
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
    fallback: userDataFolder(),
    description:
      'Folder for the data that the master keeps between runs. Created when it is missing.',
    parse: parsePath,
  }),
  modules: option<string | undefined>({
    placeholder: '<folder>',
    fallback: undefined,
    fallbackText: 'none',
    description:
      'Folder of trusted processing modules (.pm, .js): they run at full speed, with libraries.',
    parse: parsePath,
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
    parse: parsePath,
  }),
  legacyPorts: option<LegacyPorts | undefined>({
    placeholder: 'on|off|<services>,<topic data>',
    fallback: ORIGINAL_PORTS,
    fallbackText: 'on: 8102,8104',
    description: 'Ports that existing clients use. By default, a port that is in use is left out.',
    hint: 'Use --legacy-ports off to disable them',
    parse: parseLegacyPorts,
  }),
  allowedOrigins: option<readonly string[]>({
    placeholder: '<origin>,...',
    fallback: [],
    fallbackText: 'none',
    description:
      'Web pages of other origins that may call the services, besides those of this machine and, with --lan, of private addresses: https://example.org, https://*.example.org, http://example.org:*, or * for all. Those named, and not *, need not join when this machine shows them over HTTPS, or by an address.',
    hint: 'Use * to allow every page',
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
    parse: parseNumber(1, 100),
  }),
  publisherPercent: option({
    placeholder: '<percent>',
    fallback: DEFAULT_CHECKS.publisherPercent,
    description:
      "Share of the master's time, in percent, that the records of one client may take before it counts as noisy.",
    parse: parseNumber(1, 100),
  }),
  limits: option<Partial<Limits>>({
    placeholder: '<name>=<number>,...',
    fallback: {},
    fallbackText: 'defaults',
    description:
      'Limits that differ from the defaults: clients=20000,topics=500000. Settings, Limits in the frontend lists all limits with units and reasons.',
    parse: parseLimits,
  }),
  logLevel: logLevelOption,
  logFormat: option<'auto' | 'text' | 'json'>({
    placeholder: 'auto|text|json',
    fallback: 'auto',
    description:
      'Format of the log on standard error; auto is text on a terminal and JSON lines otherwise.',
    parse: parseChoice('auto', 'text', 'json'),
  }),
  ...HELP_OPTIONS,
} as const;

export type OptionName = keyof typeof OPTIONS;

/** The values the master runs with. */
export type Config = OptionValues<typeof OPTIONS> & {
  /** Options that are set in any place. Only options that are not set may change at startup. */
  readonly given: ReadonlySet<OptionName>;
};

/** The options and where they are read from. */
export const MASTER_PROGRAM: ProgramOptions<typeof OPTIONS> = {
  options: OPTIONS,
  environmentPrefix: 'UBII_',
  fileOption: 'config',
  about: `Ubi-Interact master: the frontend, the services and the topic data on one port.

  npm start -- [flags]

Each option is a flag, an environment variable and a key of the config file; the first of
them that is set applies.
`,
};
