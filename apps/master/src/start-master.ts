import { homedir } from 'node:os';
import { join } from 'node:path';
import type { AnnouncedMaster } from '@ubii/discovery';
import { moduleLibrary } from '@ubii/modules';
import { partyModules } from '@ubii/party/modules';
import { createAssetStore } from '@ubii/pm-sandbox';
import { AssetFolders } from '@ubii/pm-sandbox/node';
import { Re2Patterns } from '@ubii/patterns/re2';
import { AdminTokenFile } from './adapters/access/admin-token-file.ts';
import { CallerReader, type LoopbackFacts } from './adapters/access/caller-reader.ts';
import { HmacAccessSecrets } from './adapters/access/hmac-access-secrets.ts';
import { Networks } from './adapters/access/networks.ts';
import { PeerOwners } from './adapters/access/peer-owners.ts';
import { limitsOfMachine, openSandboxes } from './adapters/processing/open-sandboxes.ts';
import { TrustedLibrary } from './adapters/processing/trusted-library.ts';
import { MIB } from './core/limits/limit.ts';
import { DEFAULT_FLIGHT_RECORDER } from './core/recordings/flight-settings.ts';
import { createMaster, DEFAULT_LIMITS, fitConnections } from './index.ts';
import type { TerminalAccess } from './index.ts';
import { PreciseSystemClock } from './adapters/clock/precise-system-clock.ts';
import { describeConfig } from './adapters/config/describe-config.ts';
import { prepareDataDir } from './adapters/config/prepare-data-dir.ts';
import { BodyDecoder } from './adapters/services/bodies/body-decoder.ts';
import { createHttpApp } from './adapters/http/http-app.ts';
import { randomIds } from './adapters/ids/random-ids.ts';
import { announce } from './adapters/discovery/announce.ts';
import { descriptorLimit } from './adapters/network/descriptor-limit.ts';
import { ConnectionGuard } from './adapters/network/connection-guard.ts';
import { LanSwitch } from './adapters/network/lan-switch.ts';
import { Listeners } from './adapters/network/listeners.ts';
import { OwnAddresses } from './adapters/addresses/own-addresses.ts';
import { listNetworkAddresses } from './adapters/addresses/network-addresses.ts';
import { refuseOriginal } from './adapters/original/original-files.ts';
import { openOriginal } from './adapters/original/open-original.ts';
import { originsOf } from './adapters/network/page-origins.ts';
import { OriginPolicy } from './adapters/network/origin-policy.ts';
import { describeReachability } from './adapters/network/reachability.ts';
import type { Reachability } from './adapters/network/reachability.ts';
import { keepToOwner, recordingsFolder } from '@ubii/recording/node';
import { openRecordings } from './adapters/recording/open-recordings.ts';
import { AuditFile } from './adapters/storage/audit-file.ts';
import { KNOWN_MODELS } from './adapters/models/catalogue.ts';
import { StoredAssetSets } from './adapters/models/stored-asset-sets.ts';
import { HmacResumeTokens } from './adapters/tokens/hmac-resume-tokens.ts';
import { localName } from './adapters/tls/own-names.ts';
import { ProcessUsage } from './adapters/usage/process-usage.ts';
import { PreflightSockets } from './adapters/ws/preflight-sockets.ts';
import { TopicDataSockets } from './adapters/ws/topic-data-sockets.ts';
import { ZeroMqEnds } from './adapters/zeromq/zeromq-ends.ts';
import { openStores } from './open-stores.ts';
import type { RunningMasterContext, RunningMaster } from './running-master.ts';

/** Time for connections to close gracefully before they are cut, milliseconds. */
const CLOSE_GRACE_MS = 500;

/**
 * Puts core and adapters together and listens.
 *
 * @throws ConfigError when a port or the data directory cannot be had
 */
export async function startMaster({
  config,
  log,
  clock = new PreciseSystemClock(log),
  version,
  frontendFolder,
  sdkFolder,
  assetsFolders,
  workerFile,
  models = KNOWN_MODELS,
  keepAliveMs,
  decodeWorkerFile,
  recorderWorkerFile,
  checkProcessFile,
  replayWorkerFile,
}: RunningMasterContext): Promise<RunningMaster> {
  await refuseOriginal(config.dataDir);
  prepareDataDir(config.dataDir, log);
  await keepToOwner(recordingsFolder(config.dataDir));
  const limits = fitConnections(limitsOfMachine(config.limits), descriptorLimit());
  const stores = await openStores(config, limits.frameBytes ?? DEFAULT_LIMITS.frameBytes, {
    clock,
    log,
  });
  const { key, cluster, installation } = stores;
  const tokens = new HmacResumeTokens(key);
  const lan = await LanSwitch.create({
    config,
    log,
    move: (reach) => listeners.move(reach),
    onOpen: () => announceIfWished(),
  });
  const ownAddresses = new OwnAddresses();
  const clusterOrigins = (): string[] => originsOf(master.otherMasterAddresses());
  const policy = new OriginPolicy({
    isOnLan: () => lan.isOpen,
    host: lan.host,
    allowedOrigins: config.allowedOrigins,
    publicUrl: config.publicUrl,
    isOwnAddress: (address) => ownAddresses.has(address),
    clusterOrigins,
  });
  const legacyNetworks = new Networks(config.allowLegacy);
  const proxies = new Networks(config.trustedProxy);
  const owners = new PeerOwners();
  const loopback: LoopbackFacts['role'] = config.trustLoopback ? 'admin' : config.loopback;
  const callers = new CallerReader({
    policy,
    loopback,
    isOwnAddress: (address) => ownAddresses.has(address),
    isLegacyAddress: (address) => legacyNetworks.has(address),
    isTrustedProxy: (address) => proxies.has(address),
    owners,
  });
  const { sandboxes, libraries } = openSandboxes(workerFile, config.allowFetch, limits);
  const library = await TrustedLibrary.open(
    [...moduleLibrary(), ...partyModules()],
    config.modules,
    log,
  );
  const storage = await openOriginal(stores.storage, config.originalData, {
    sandboxes,
    clock,
    log,
    library,
  });
  const modelsFolder = join(config.dataDir, 'models');
  const assets = new AssetFolders([...assetsFolders, modelsFolder]);
  const recordings = recordingsFolder(config.dataDir);
  const audit = new AuditFile({
    folder: join(config.dataDir, 'audit'),
    maxLines: limits.auditEntries ?? DEFAULT_LIMITS.auditEntries,
    log,
  });
  const reachability = (): Reachability =>
    describeReachability(lan.host, listeners.ports, listNetworkAddresses(), {
      isSecure: lan.https !== undefined,
      publicUrl: config.publicUrl,
    });

  const assetSets = new StoredAssetSets({
    assets,
    folder: modelsFolder,
    models,
    mirror: config.modelMirror,
    log,
    clock,
  });
  const master = createMaster(
    {
      clock,
      ids: randomIds,
      tokens,
      accessSecrets: new HmacAccessSecrets(key),
      grants: storage.grants,
      personalData: storage.personalData,
      studyStorage: storage.studyStorage,
      audit,
      log,
      logTail: log,
      patterns: new Re2Patterns({
        length: limits.patternLength,
        instructions: limits.patternInstructions,
      }),
      usage: new ProcessUsage(),
      lan,
      sandboxes,
      assets: createAssetStore(assets),
      assetSets,
      storage,
      ...(cluster && { cluster }),
      ...openRecordings({
        folder: recordings,
        limits: { ...DEFAULT_LIMITS, ...limits },
        clock,
        log,
        recorderWorkerFile,
        checkProcessFile,
        replayWorkerFile,
      }),
      library: () => library.modules(),
    },
    {
      name: config.name,
      ...(installation !== undefined && { installation }),
      version,
      limits,
      libraries,
      flightRecorder: {
        isOn: config.flightRecorder !== undefined,
        minutes: config.flightRecorder ?? DEFAULT_FLIGHT_RECORDER.minutes,
        maxBytes: config.flightRecorderMib * MIB,
      },
      startedWith: describeConfig(config, homedir()),
      checks: {
        checks: config.checks,
        busyPercent: config.busyPercent,
        publisherPercent: config.publisherPercent,
      },
      endpoints: () => reachability().endpoints,
    },
  );
  const connectionGuard = new ConnectionGuard({
    master,
    isOwnAddress: (each) => ownAddresses.has(each),
  });
  const sockets = new TopicDataSockets({
    master,
    policy,
    callers,
    log,
    clock,
    connectionGuard,
    preflights: new PreflightSockets(clock),
  });
  const decoder = new BodyDecoder({ workerFile: decodeWorkerFile, clock, log });
  const app = await createHttpApp({
    master,
    policy,
    clusterOrigins,
    callers,
    log,
    name: config.name,
    version,
    clock,
    limits,
    decoder,
    connectionGuard,
    frontendFolder,
    sdkFolder,
    assets,
    recordingsFolder: recordings,
    authority: () => lan.https?.authority,
  });
  const zeromq = new ZeroMqEnds({ master, callers, log, clock, connectionGuard, decoder, limits });
  const loopbackFacts = { role: loopback, tellsOwners: owners.canTell };
  if (loopback === 'admin' && !owners.canTell) {
    log.warn(
      'this system does not report which user a program belongs to: with --trust-loopback every user of this machine, and every proxy that does not name its clients, is an admin',
    );
  }
  /** A master that cannot keep anything goes on as it is. */
  const openTerminal = async (): Promise<TerminalAccess | undefined> => {
    try {
      const terminal = await master.openTerminal(lan.isOpen || config.publicUrl !== undefined);
      tokenFile = new AdminTokenFile(config.dataDir, terminal.admin.token);
      return terminal;
    } catch (error) {
      log.warn('the admin token of this run could not be created', { reason: String(error) });
      return undefined;
    }
  };
  const listeners = new Listeners({
    host: lan.host,
    log,
    onePort: lan.https?.onePort,
    connectionGuard,
    timeouts: {
      headersMs: limits.headersTimeoutMs,
      stillMs: limits.slowSocketTimeoutMs,
      keepAliveMs,
    },
    handleRequest: (request, response) => app.routing(request, response),
    handleUpgrade: (request, socket, head) => sockets.handleUpgrade(request, socket, head),
    zeromq,
  });

  let tokenFile: AdminTokenFile | undefined;
  let announced: AnnouncedMaster | undefined;
  const announceIfWished = (): void => {
    // With an address of a proxy, clients must not find another one.
    if (config.mdns === 'off' || config.publicUrl !== undefined) return;
    announced = announce({
      id: master.id,
      name: config.name,
      version,
      ports: listeners.ports,
      https: lan.https !== undefined,
      host: localName(),
      reachability,
      log,
    });
  };
  const close = async (): Promise<void> => {
    tokenFile?.close();
    const closed = listeners.close();
    zeromq.close();
    const withdrawn = announced?.close();
    const ended = master.close();
    library.close();
    lan.close();
    const cut = setTimeout(() => {
      sockets.terminate();
      zeromq.terminate();
      listeners.cut();
    }, CLOSE_GRACE_MS);
    await closed;
    clearTimeout(cut);
    decoder.close();
    await Promise.all([assetSets.close(), app.close(), ended, audit.settled(), withdrawn]);
    await stores.close();
  };

  try {
    await listeners.open({
      main: config.port,
      legacy: config.legacyPorts,
      legacyWished: config.given.has('legacyPorts'),
      zeromq: config.zeromqPorts,
    });
    if (lan.isOpen) announceIfWished();
    const terminal = await openTerminal();
    return {
      ports: listeners.ports,
      reachability,
      terminal,
      loopback: loopbackFacts,
      sessionsAtStop: () => master.sessionsAtStop(),
      sessionsRestored: () => master.sessionsRestored(),
      close,
    };
  } catch (error) {
    await close();
    throw error;
  }
}
