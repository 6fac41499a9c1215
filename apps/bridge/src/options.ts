import {
  checkJoining,
  identityOption,
  JOINING_OPTIONS,
  nameOption,
  printEndpointsOption,
} from '@ubii/client-program';
import {
  ConfigError,
  HELP_OPTIONS,
  logLevelOption,
  option,
  parseChoice,
  parseWholeNumber,
  pathOption,
} from '@ubii/program';
import type { OptionValues, ProgramOptions } from '@ubii/program';
import type { Protocol } from './core/mapping/mapping.ts';

/** Every option. */
export const OPTIONS = {
  ...JOINING_OPTIONS,
  mapping: pathOption(
    '<file>',
    'bridge.json',
    'File with the mappings, as JSON (docs/guides/a-bridge.md). Changes apply at once. Without this option, the page Bridges creates it.',
  ),
  protocol: option<Protocol | undefined>({
    placeholder: 'mqtt|osc|rosbridge',
    fallback: undefined,
    fallbackText: 'as the address says',
    description: 'Protocol of the other system, where its address does not say it: ws://host:9090.',
    parse: parseChoice('mqtt', 'osc', 'rosbridge'),
  }),
  name: nameOption('bridge'),
  credentialsFile: pathOption(
    '<file>',
    'none',
    'File with the user in its first line and the password in its second. Or set UBII_BRIDGE_USER and UBII_BRIDGE_PASSWORD.',
  ),
  ca: pathOption(
    '<file>',
    "the system's",
    'Certificate authority of the other system (PEM), for mqtts:// and wss://.',
  ),
  listen: option<number | undefined>({
    placeholder: '<port>',
    fallback: undefined,
    fallbackText: 'any free one',
    description: 'UDP port at which OSC messages are received.',
    parse: parseWholeNumber(0, 65_535),
  }),
  identity: identityOption,
  printEndpoints: printEndpointsOption,
  logLevel: logLevelOption,
  ...HELP_OPTIONS,
} as const;

/** The values of all options. */
export type Config = OptionValues<typeof OPTIONS>;

/** The options and where they are read from. */
export const BRIDGE_PROGRAM: ProgramOptions<typeof OPTIONS> = {
  options: OPTIONS,
  environmentPrefix: 'UBII_BRIDGE_',
  takesWords: true,
  about: `Ubi-Interact bridge: connects the topics of a master with MQTT, OSC or ROS.

  npm run bridge -- mqtt://localhost:1883 [flags]
  npm run bridge -- osc://192.168.1.30:9000 --listen 9001 [flags]
  npm run bridge -- rosbridge://robot:9090 [flags]

Each option is a flag and an environment variable. When both are set, the flag applies.
`,
  check: checkJoining,
};

/** Where the other system is. */
export interface Target {
  readonly protocol: Protocol;
  /** As the libraries take it. */
  readonly url: string;
  readonly host: string;
  readonly port: number;
  /** How messages and other bridges name the system. */
  readonly system: string;
}

const SCHEMES: Readonly<
  Record<string, { protocol: Protocol; port: number; scheme: string } | undefined>
> = {
  'mqtt:': { protocol: 'mqtt', port: 1883, scheme: 'mqtt:' },
  'mqtts:': { protocol: 'mqtt', port: 8883, scheme: 'mqtts:' },
  'osc:': { protocol: 'osc', port: 9000, scheme: 'osc:' },
  'rosbridge:': { protocol: 'rosbridge', port: 9090, scheme: 'ws:' },
  'ws:': { protocol: 'rosbridge', port: 9090, scheme: 'ws:' },
  'wss:': { protocol: 'rosbridge', port: 9090, scheme: 'wss:' },
};

const EXAMPLES = 'mqtt://localhost:1883, osc://192.168.1.30:9000 or rosbridge://robot:9090';

/** @throws ConfigError with what to write instead */
export function parseTarget(words: readonly string[], protocol: Protocol | undefined): Target {
  const [text] = words;
  if (text === undefined || words.length > 1) {
    throw new ConfigError(`Give the address of one other system, such as ${EXAMPLES}.`);
  }
  const url = URL.canParse(text) ? new URL(text) : undefined;
  const known = url && SCHEMES[url.protocol];
  if (url === undefined || known === undefined || url.hostname === '') {
    throw new ConfigError(`The address of the other system must be like ${EXAMPLES}.`);
  }
  // Never repeated in the message: the list of processes shows it to all users of the machine. [BR-43]
  if (url.username !== '' || url.password !== '') {
    throw new ConfigError(
      'The address must not have a user or a password, because other users of this computer can read the command line. Use --credentials-file, or set UBII_BRIDGE_USER and UBII_BRIDGE_PASSWORD.',
    );
  }
  if (protocol !== undefined && protocol !== known.protocol) {
    throw new ConfigError(
      `The address ${text} is for ${known.protocol}, but --protocol says ${protocol}. Change one of them.`,
    );
  }
  const port = url.port === '' ? known.port : Number(url.port);
  const host = url.hostname.replace(/^\[(.*)\]$/, '$1');
  return {
    protocol: known.protocol,
    host,
    port,
    url: `${known.scheme}//${url.hostname}:${port}${known.protocol === 'rosbridge' ? url.pathname : ''}`,
    system: `${known.protocol} ${url.hostname.toLowerCase()}:${port}`,
  };
}
