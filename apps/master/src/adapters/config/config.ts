import { hostname } from 'node:os';
import {
  choiceOption,
  ConfigError,
  flagName,
  HELP_OPTIONS,
  listOption,
  logLevelOption,
  option,
  parseChoice,
  parseFetchOrigins,
  parseName,
  parseNumber,
  parsePath,
  parseSwitch,
  pathOption,
  userDataFolder,
} from '@ubii/program';
import type { OptionValues, ProgramOptions, ReadOptions } from '@ubii/program';

import { parseCluster, parseClusterName, type ClusterAddress } from './cluster-address.ts';
import { ORIGINAL_PORTS, type LegacyPorts } from './legacy-ports.ts';
import {
  parseFlightMinutes,
  parseHost,
  parseLegacyPorts,
  parseLimits,
  parseMirror,
  parseNetworks,
  parseOrigins,
  parsePort,
  parsePublicUrl,
  parseZeroMqPorts,
} from './parse-values.ts';

import { DEFAULT_CHECKS } from '../../core/checks/check-settings.ts';
import { MIB } from '../../core/limits/limit.ts';
import { DEFAULT_FLIGHT_RECORDER } from '../../core/recordings/flight-settings.ts';
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
  allowLegacy: listOption(
    '<network>,...',
    'Networks whose existing clients are participants without joining, because they do not support codes: 192.168.1.0/24,10.0.0.7. For this machine, see --loopback.',
    parseNetworks,
  ),
  loopback: choiceOption(
    ['participant', 'none'],
    'participant',
    'Role of programs and pages of this machine that send no token: participant, so that existing clients work, or none. The address or code in the terminal makes an admin.',
  ),
  trustLoopback: option({
    placeholder: '[on|off]',
    fallback: false,
    fallbackText: 'off',
    description:
      'Programs and pages of this machine are admins without a token, as in earlier versions. Use it only on a machine with one user and without a proxy.',
    parse: parseSwitch,
  }),
  trustedProxy: listOption(
    '<network>,...',
    'Networks of proxies that name their clients in X-Forwarded-For or Forwarded: 10.0.0.7,192.168.2.0/24. Clients behind any other proxy have to join.',
    parseNetworks,
  ),
  publicUrl: option<string | undefined>({
    placeholder: '<url>',
    fallback: undefined,
    fallbackText: 'the addresses of this machine',
    description:
      'Address by which others reach the master, such as that of a proxy: https://ubii.example.org. QR codes, pages and other masters show it instead of the addresses of this machine, and nothing is announced by multicast DNS.',
    parse: parsePublicUrl,
  }),
  https: choiceOption(
    ['on', 'off'],
    'on',
    'HTTPS on the same port as HTTP, when other machines can reach the master. Browsers give sensors and cameras to HTTPS pages only. The master creates its certificates itself.',
  ),
  tlsCertificate: pathOption(
    '<file>',
    'its own',
    'Certificate for HTTPS from another authority, with its chain, as PEM.',
  ),
  tlsKey: {
    ...pathOption('<file>', 'its own', 'Private key of that certificate, as PEM.'),
    isSecret: true,
  },
  tlsAuthority: {
    ...pathOption(
      '<file>',
      'its own',
      'Certificate and key of the authority that issues the certificates of this master, in one PEM file, created when missing. Give all masters of a cluster the same file: devices that trust one of them then trust all, and pages over HTTPS can move.',
    ),
    isSecret: true,
  },
  mdns: choiceOption(
    ['on', 'off'],
    'on',
    'Announce this master in the local network (_ubii._tcp, multicast DNS), when other machines can reach it, so that programs find it without its address.',
  ),
  dataDir: option({
    placeholder: '<folder>',
    fallback: userDataFolder(),
    description:
      'Folder for the data that the master keeps between runs. Created when it is missing.',
    parse: parsePath,
  }),
  modules: pathOption(
    '<folder>',
    'none',
    'Folder of trusted processing modules (.pm, .js): they run at full speed, with libraries.',
  ),
  originalData: pathOption(
    '<folder>',
    'none',
    'Folder of an original Ubi-Interact master, or its database folder: its sessions and processing modules are listed and run, in sandboxes. Its files are never changed.',
  ),
  allowFetch: listOption(
    '<origin>,...',
    'Origins that modules with the library http may read from: https://example.org,http://sensor.local:8000.',
    parseFetchOrigins,
  ),
  modelMirror: option<string | undefined>({
    placeholder: '<url>',
    fallback: undefined,
    fallbackText: 'the publishers',
    description:
      'Where models are downloaded from instead of their publishers, for rooms without internet: a folder as models/ of the data directory, such as http://10.0.0.7/models/. Sizes and hashes are verified anyway.',
    parse: parseMirror,
  }),
  config: pathOption('<file>', 'none', 'JSON file with options: { "port": 9000, "lan": false }.'),
  flightRecorder: option<number | undefined>({
    placeholder: 'off|<minutes>',
    fallback: DEFAULT_FLIGHT_RECORDER.minutes,
    description:
      'Minutes of all topics that the master keeps in memory, so that they can still be recorded afterwards; off keeps nothing. Admins can change it while the master runs.',
    parse: parseFlightMinutes,
  }),
  flightRecorderMib: option({
    placeholder: '<number>',
    fallback: DEFAULT_FLIGHT_RECORDER.maxBytes / MIB,
    description: 'Memory that the flight recorder takes at most, MiB.',
    parse: parseNumber(1, 512),
  }),
  legacyPorts: option<LegacyPorts | undefined>({
    placeholder: 'on|off|<services>,<topic data>',
    fallback: ORIGINAL_PORTS,
    fallbackText: 'on: 8102,8104',
    description: 'Ports that existing clients use. By default, a port that is in use is left out.',
    hint: 'Use --legacy-ports off to disable them',
    parse: parseLegacyPorts,
  }),
  zeromqPorts: option<LegacyPorts | undefined>({
    placeholder: 'on|off|<services>,<topic data>',
    fallback: undefined,
    fallbackText: 'off',
    description:
      'Ports for existing clients that use ZeroMQ; on means 8101,8103. Not encrypted, as over HTTP.',
    hint: 'Use --zeromq-ports on for 8101,8103',
    parse: parseZeroMqPorts,
  }),
  allowedOrigins: {
    ...listOption(
      '<origin>,...',
      'Web pages of other origins that may call the services, besides those of this machine and, with --lan, of private addresses: https://example.org, https://*.example.org, http://example.org:*, or * for all. Those named, and not *, need not join when this machine shows them over HTTPS, or by an address.',
      parseOrigins,
    ),
    hint: 'Use * to allow every page',
  },
  cluster: {
    ...option<ClusterAddress | undefined>({
      placeholder: '<url>,...',
      fallback: undefined,
      fallbackText: 'none',
      description:
        'NATS servers with JetStream, by which several masters work as one: tls://10.0.0.7:4222, or nats:// on this machine. Sessions, modules, invitations and studies of the cluster are kept there instead of in the data directory.',
      parse: parseCluster,
    }),
    isSecret: true,
  },
  clusterName: option({
    placeholder: '<name>',
    fallback: 'ubii',
    description: 'Name of the cluster. Masters with the same name and NATS servers work as one.',
    parse: parseClusterName,
  }),
  clusterCredentials: {
    ...pathOption(
      '<file>',
      'none',
      'File with what NATS asks of the masters: a .creds file, or one line with user:password or a token.',
    ),
    isSecret: true,
  },
  clusterCa: pathOption(
    '<file>',
    "the system's",
    'Certificates of the authorities of the NATS servers, PEM. With it, connections to NATS are encrypted.',
  ),
  clusterInsecure: option({
    placeholder: '[on|off]',
    fallback: false,
    fallbackText: 'off',
    description:
      'Uses NATS servers without TLS on other machines, and those that programs of other machines can use without a login. Each such program can act as a master. Use it only in a network of the machines of the cluster alone.',
    parse: parseSwitch,
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
  checks: choiceOption(
    ['off', 'warn', 'throttle'],
    DEFAULT_CHECKS.checks,
    'Reaction to overload by a publisher, a module or the master: nothing, a warning, or a warning and a throttle for noisy publishers.',
  ),
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
  logFormat: choiceOption(
    ['auto', 'text', 'json'],
    'auto',
    'Format of the log on standard error; auto is text on a terminal and JSON lines otherwise.',
  ),
  ...HELP_OPTIONS,
} as const;

export type OptionName = keyof typeof OPTIONS;

/** The values the master runs with. */
export type Config = OptionValues<typeof OPTIONS> & {
  /** Options that are set in any place. Only options that are not set may change at startup. */
  readonly given: ReadonlySet<OptionName>;
};

/** Returns what the master runs with: one who says where to listen does not want all networks. */
export function createConfig({ values, given }: ReadOptions<typeof OPTIONS>): Config {
  return { ...values, given, lan: values.lan && !given.has('host') };
}

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
  check(values, given) {
    if (values.lan && given.has('lan') && given.has('host')) {
      throw new ConfigError(
        `--lan listens on all networks and --host on "${values.host}" only. Remove one of them.`,
      );
    }
    if (values.trustLoopback && values.loopback === 'none') {
      throw new ConfigError(
        '--trust-loopback makes callers of this machine admins, and --loopback none gives them no access. Remove one of them.',
      );
    }
    const needsCluster = (
      ['clusterName', 'clusterCredentials', 'clusterCa', 'clusterInsecure'] as const
    ).find((name) => given.has(name));
    if (needsCluster !== undefined && values.cluster === undefined) {
      throw new ConfigError(
        `${flagName(needsCluster)} is of use with --cluster only. Give --cluster with the addresses of the NATS servers.`,
      );
    }
    if (values.clusterCredentials !== undefined && values.cluster?.login !== undefined) {
      throw new ConfigError(
        'Both --cluster and --cluster-credentials have a login for NATS. Remove one of them.',
      );
    }
    const { zeromqPorts: zeromq, legacyPorts: legacy } = values;
    const taken = [values.port, legacy?.services, legacy?.topicData];
    const own = [zeromq?.services, zeromq?.topicData].filter((port) => port !== undefined);
    const double = own.find(
      (port, i) => port !== 0 && [...taken, ...own.slice(i + 1)].includes(port),
    );
    if (double !== undefined) {
      throw new ConfigError(
        `Port ${double} of --zeromq-ports cannot be used for anything else. Choose another one.`,
      );
    }
    if (values.tlsAuthority !== undefined && values.tlsCertificate !== undefined) {
      throw new ConfigError(
        'With --tls-certificate the master issues no certificates, and has no use for --tls-authority. Remove one of them.',
      );
    }
    if ((values.tlsCertificate === undefined) !== (values.tlsKey === undefined)) {
      throw new ConfigError(
        'A certificate and its key belong together: give both --tls-certificate and --tls-key, or neither.',
      );
    }
  },
};
