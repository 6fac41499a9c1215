import { readFileSync } from 'node:fs';

/** Between two samples: what holds a thread for half a millisecond has some. */
const INTERVAL_US = 200;

/** Returns flags of Node that write a CPU profile of the whole run when the program stops. */
export function cpuProfileFlags(folder: string | undefined, name: string): readonly string[] {
  if (folder === undefined) return [];
  const interval = `--cpu-prof-interval=${INTERVAL_US}`;
  return ['--cpu-prof', interval, `--cpu-prof-dir=${folder}`, `--cpu-prof-name=${name}.cpuprofile`];
}

/** Flags with values that hold unless they are given. */
const DEFAULTS = [
  ['--port', '0'],
  ['--legacy-ports', 'off'],
  ['--mdns', 'off'],
  ['--log-format', 'json'],
] as const;

/** Flags of Node that `npm start` gives. */
const STARTED_WITH = JSON.parse(
  readFileSync(new URL('../../../../apps/master/node-flags.json', import.meta.url), 'utf8'),
) as readonly string[];

/** How a master is started. */
export interface MasterStart {
  /** Main file of a built master. Default: `BUILT_MASTER` */
  readonly program?: string;
  /** Default: a new folder, which `dispose()` removes. */
  readonly dataDir?: string;
  /** Flags that say where it listens. Default: IPv4 loopback only */
  readonly network?: readonly string[];
  /** Further flags, such as `--port`. Defaults: any free port, no legacy ports, no mDNS, the log as JSON lines */
  readonly flags?: readonly string[];
  /** Whether local callers are admins without a token, if the build distinguishes. Default: true */
  readonly trustsLoopback?: boolean;
  /** Flags of Node itself, such as `--inspect=127.0.0.1:0`. */
  readonly nodeFlags?: readonly string[];
  /** Command that starts it elsewhere, such as `ip netns exec x`. */
  readonly within?: readonly string[];
  /** Soft limit of open descriptors. */
  readonly maxDescriptors?: number;
  /** Folder for a CPU profile of each run, written when the master stops. */
  readonly profileDir?: string | undefined;
  /** Name of the profile. Default: ubii */
  readonly profileName?: string;
}

/** Paths that are known when a master is started. */
export interface ResolvedStart extends MasterStart {
  readonly program: string;
  readonly dataDir: string;
}

/** Returns program and arguments that start the master. @param isTrusted passes `--trust-loopback` */
export function masterCommand(start: ResolvedStart, isTrusted: boolean): readonly string[] {
  const { network = ['--host', '127.0.0.1'], flags = [], nodeFlags = [], within = [] } = start;
  return [
    ...within,
    ...limitDescriptors(start.maxDescriptors),
    process.execPath,
    ...cpuProfileFlags(start.profileDir, start.profileName ?? 'ubii'),
    ...STARTED_WITH,
    ...nodeFlags,
    start.program,
    ...network,
    ...DEFAULTS.filter(([name]) => !flags.includes(name)).flat(),
    ...(isTrusted ? ['--trust-loopback'] : []),
    '--data-dir',
    start.dataDir,
    '--print-endpoints',
    'json',
    ...flags,
  ];
}

function limitDescriptors(max: number | undefined): readonly string[] {
  return max === undefined ? [] : ['bash', '-c', `ulimit -n ${max}; exec "$@"`, 'limited'];
}
