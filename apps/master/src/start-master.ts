import { homedir, hostname } from 'node:os';
import type { AnnouncedMaster } from '@ubii/discovery';
import { moduleLibrary } from '@ubii/modules';
import { CallerReader } from './adapters/access/caller-reader.ts';
import { HmacAccessSecrets } from './adapters/access/hmac-access-secrets.ts';
import { LegacyNetworks } from './adapters/access/legacy-networks.ts';
import { openSandboxes } from './adapters/processing/open-sandboxes.ts';
import { TrustedLibrary } from './adapters/processing/trusted-library.ts';
import { createMaster, DEFAULT_LIMITS } from './index.ts';
import type { LogTail, TerminalJoin } from './index.ts';
import { SystemClock } from './adapters/clock/system-clock.ts';
import { describeConfig } from './adapters/config/describe-config.ts';
import { prepareDataDir } from './adapters/config/prepare-data-dir.ts';
import { createHttpApp } from './adapters/http/http-app.ts';
import { randomIds } from './adapters/ids/random-ids.ts';
import { announce } from './adapters/discovery/announce.ts';
import { isLoopbackHost } from './adapters/network/address-kinds.ts';
import { Listeners } from './adapters/network/listeners.ts';
import type { ListeningPorts } from './adapters/network/listeners.ts';
import { OwnAddresses } from './adapters/network/own-addresses.ts';
import { listNetworkAddresses } from './adapters/network/network-addresses.ts';
import { ALL_NETWORKS } from './adapters/network/open-port.ts';
import { OriginPolicy } from './adapters/network/origin-policy.ts';
import { describeReachability } from './adapters/network/reachability.ts';
import type { Reachability } from './adapters/network/reachability.ts';
import { Re2Patterns } from './adapters/patterns/re2-patterns.ts';
import { openStorage } from './adapters/storage/open-storage.ts';
import { HmacResumeTokens } from './adapters/tokens/hmac-resume-tokens.ts';
import { readOrCreateTokenKey } from './adapters/tokens/token-key-file.ts';
import { localName } from './adapters/tls/own-names.ts';
import { openHttps } from './adapters/tls/open-https.ts';
import { ProcessUsage } from './adapters/usage/process-usage.ts';
import { PreflightSockets } from './adapters/ws/preflight-sockets.ts';
import { TopicDataSockets } from './adapters/ws/topic-data-sockets.ts';
import type { Config } from './config.ts';

/** How long connections may take to end in good order before they are cut. */
const CLOSE_GRACE_MS = 500;

export interface MasterParts {
  readonly config: Config;
  readonly log: LogTail;
  readonly version: string;
  /** The built frontend. */
  readonly frontendFolder: string;
  /** The built worker of processing modules. */
  readonly workerFile: URL;
}

/** A master that listens. */
export interface RunningMaster {
  readonly ports: ListeningPorts;
  /** Asked anew each time: networks come and go. */
  reachability(): Reachability;
  /** What others join with, until this run ends; undefined when only this machine reaches it [AC-19]. */
  readonly join: TerminalJoin | undefined;
  /** Closes everything, within a second. */
  close(): Promise<void>;
}

/**
 * Puts core and adapters together and listens.
 *
 * @throws ConfigError when a port or the data directory cannot be had
 */
export async function startMaster({
  config,
  log,
  version,
  frontendFolder,
  workerFile,
}: MasterParts): Promise<RunningMaster> {
  prepareDataDir(config.dataDir);
  const key = readOrCreateTokenKey(config.dataDir);
  const tokens = new HmacResumeTokens(key);
  const host = config.lan ? ALL_NETWORKS : config.host;
  const ownAddresses = new OwnAddresses();
  const policy = new OriginPolicy({
    onLan: !isLoopbackHost(host),
    host,
    allowedOrigins: config.allowedOrigins,
    isOwnAddress: (address) => ownAddresses.has(address),
    ownNames: [hostname().toLowerCase(), hostname().split('.')[0]?.toLowerCase() ?? ''],
  });
  const legacyNetworks = new LegacyNetworks(config.allowLegacy);
  const callers = new CallerReader({
    policy,
    isOwnAddress: (address) => ownAddresses.has(address),
    isLegacyAddress: (address) => legacyNetworks.has(address),
  });
  const https = await openHttps(config, host, log);
  const limits = { ...DEFAULT_LIMITS, ...config.limits };
  const { sandboxes, libraries } = openSandboxes(workerFile, config.allowFetch);
  const storage = openStorage(config.dataDir);
  const library = await TrustedLibrary.open(moduleLibrary(), config.modules, log);
  const reachability = (): Reachability =>
    describeReachability(host, listeners.ports, listNetworkAddresses(), https !== undefined);

  const clock = new SystemClock(log);
  const master = createMaster(
    {
      clock,
      ids: randomIds,
      tokens,
      accessSecrets: new HmacAccessSecrets(key),
      grants: storage.grants,
      log,
      logTail: log,
      patterns: new Re2Patterns(limits.patternInstructions),
      usage: new ProcessUsage(),
      sandboxes,
      storage,
      library: () => library.modules(),
    },
    {
      name: config.name,
      version,
      limits,
      libraries,
      startedWith: describeConfig(config, homedir()),
      checks: {
        checks: config.checks,
        busyPercent: config.busyPercent,
        publisherPercent: config.publisherPercent,
      },
      endpoints: () => reachability().endpoints,
    },
  );
  const sockets = new TopicDataSockets({
    master,
    policy,
    callers,
    log,
    preflights: new PreflightSockets(clock),
    maxMessageBytes: limits.frameBytes,
  });
  const app = await createHttpApp({
    master,
    policy,
    callers,
    log,
    name: config.name,
    version,
    maxRequestBytes: limits.frameBytes,
    frontendFolder,
    authority: https?.authority,
  });
  const listeners = new Listeners({
    host,
    log,
    onePort: https?.onePort,
    handleRequest: (request, response) => app.routing(request, response),
    handleUpgrade: (request, socket, head) => sockets.handleUpgrade(request, socket, head),
  });

  let announced: AnnouncedMaster | undefined;
  const close = async (): Promise<void> => {
    const closed = listeners.close();
    const withdrawn = announced?.close();
    const ended = master.close();
    library.close();
    https?.close();
    const cut = setTimeout(() => {
      sockets.terminate();
      listeners.cut();
    }, CLOSE_GRACE_MS);
    await closed;
    clearTimeout(cut);
    await Promise.all([app.close(), ended, storage.settled(), withdrawn]);
  };

  try {
    await listeners.open({
      main: config.port,
      legacy: config.legacyPorts,
      legacyWished: config.given.has('legacyPorts'),
    });
    if (config.mdns === 'on' && !isLoopbackHost(host)) {
      announced = announce({
        id: master.id,
        name: config.name,
        version,
        ports: listeners.ports,
        https: https !== undefined,
        host: localName(),
        reachability,
        log,
      });
    }
    const join = isLoopbackHost(host) ? undefined : await master.openTerminal();
    return { ports: listeners.ports, reachability, join, close };
  } catch (error) {
    await close();
    throw error;
  }
}
