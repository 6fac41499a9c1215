import {
  type UbiiClient,
  createClient,
  createIdentityFile,
  createMemoryIdentity,
  defaultIdentityFile,
  type IdentityStorage,
} from '@ubii/client-web/node';
import { type Clock, within } from '@ubii/timing';
import { createStateLog, type Log } from '@ubii/client-program';
import { systemClock } from '@ubii/timing/system';
import { counted } from '@ubii/words';
import { answerOrders } from './adapters/master/answer-orders.ts';
import { cachedTopics } from './adapters/master/client-topic-master.ts';
import { answerMappingOrder } from './core/mapping/answer-mapping-order.ts';
import type { MappingStore } from './core/mapping/mapping-store.ts';
import { SeenAddresses } from './core/engine/seen-addresses.ts';
import type { ForeignState } from './core/ports/foreign-system.ts';
import { bridgeTag, OtherBridges } from './core/loop/other-bridges.ts';
import type { MappingFile } from './core/mapping/read-mapping-file.ts';
import { createLink, type RunningLink } from './create-link.ts';
import type { Credentials } from './credentials.ts';
import type { Config, Target } from './options.ts';
import { createStandBy } from './stand-by.ts';
import { openMappingStore, watchMappingFile } from './open-mapping-store.ts';

const INTERVAL_MS = 1_000;

/** Topic on which a bridge says how it does, as JSON. [BR-33] */
function bridgeTopic(clientId: string): string {
  return `/${clientId}/bridge`;
}

/** Publishes the report each second, when it has changed. @returns ends it */
function startReports(client: UbiiClient, clock: Clock, report: () => object): () => void {
  let published = '';
  const publish = (): void => {
    const text = JSON.stringify({ version: 1, ...report() });
    const key = `${client.id} ${text}`;
    if (client.state.status !== 'connected' || key === published) return;
    published = key;
    client.publish(bridgeTopic(client.id), 'string', text);
  };
  publish();
  return clock.every(INTERVAL_MS, publish);
}

/** Time for each step of the shutdown, milliseconds. */
const STOP_TIMEOUT_MS = 800;

const PASSES = 'Passes its mappings';
const STANDS_BY = 'Stands by: another bridge with the same mappings passes them';

/** Arguments of `startBridge`. */
interface BridgeSettings {
  readonly config: Config;
  readonly target: Target;
  readonly credentials: Credentials;
  readonly ca: Buffer | undefined;
  readonly log: Log;
}

/** A bridge that is connected or connecting. */
interface RunningBridge {
  readonly client: UbiiClient;
  /** Leaves both sides. Resolves after at most two `STOP_TIMEOUT_MS`. */
  close(): Promise<void>;
}

/**
 * Starts a bridge. It connects to the other system when it has reached the master for the first time, and tries both until it
 * succeeds.
 *
 * @throws ConfigError when the mapping file is missing or wrong
 */
export function startBridge(setup: BridgeSettings): RunningBridge {
  const { config, target, log } = setup;
  const store = openMappingStore(config.mapping, target.protocol);
  const system = store.file.system ?? target.system;
  const seen = new SeenAddresses();
  const client = createBridgeClient(setup, system);
  let link: RunningLink | undefined;
  let reports: (() => void) | undefined;
  let masterId = '';
  let isOpening = false;
  const onError = (error: unknown): void => log('warn', messageOf(error));
  const bridges = new OtherBridges(system);
  const standBy = createStandBy({
    client,
    bridges,
    clock: systemClock,
    file: () => store.file,
    onChange(isActive) {
      log('info', isActive ? PASSES : STANDS_BY);
      link?.refresh();
      if (isActive) link?.setAvailable(client.state.status === 'connected');
    },
  });

  const openLink = async (): Promise<void> => {
    ({ id: masterId } = await client.call('serverConfiguration'));
    link?.setAvailable(true);
    if (isOpening) return standBy.handleConnected();
    isOpening = true;
    const { credentials, ca } = setup;
    const opened = createLink({
      client,
      target,
      bridges,
      credentials,
      ca,
      listen: config.listen,
      file: () => store.file,
      seen,
      isActive: () => standBy.isActive,
      masterId: () => masterId,
      onState: createSystemLog(log, target),
      onError,
    });
    // Before anything is passed on: what other bridges publish came from the same system. [BR-22]
    await standBy.handleConnected();
    link = opened;
    opened.setAvailable(client.state.status === 'connected');
    opened.open();
    reports = startReports(client, systemClock, () => ({
      protocol: target.protocol,
      system,
      file: store.path,
      revision: store.revision,
      isStandingBy: !standBy.isActive,
      ...opened.report(),
    }));
  };
  client.onState(createStateLog(log, () => client.masterUrl ?? config.master, 'bridge'));
  client.onMaster(({ url, previousUrl }) =>
    log('warn', `${previousUrl} was lost. Moved to ${url}`),
  );
  client.onState(({ status }) => {
    if (status === 'connected') openLink().catch(onError);
    else {
      link?.setAvailable(false);
      standBy.handleLost();
    }
  });
  client.onError(onError);
  client.connect().catch((error: unknown) => {
    log('error', `The bridge no longer tries to connect: ${messageOf(error)}`);
  });
  log('info', describeStore(store));
  let applied = store.file;
  const apply = (by: string): void => {
    warnOfRestart(applied, store.file, log);
    applied = store.file;
    standBy.update();
    link?.refresh();
    log('info', `${describeStore(store)}, changed ${by}`);
  };
  const unwatch = watchMappingFile(store, () => {
    const { path, fileProblem, file } = store;
    if (fileProblem !== '') {
      log('error', `${path}: ${fileProblem} The mappings stay as they are.`);
    } else if (file !== applied) apply('in the file');
  });
  const topics = cachedTopics(client, systemClock);
  const unanswer = answerOrders(client, (order) =>
    answerMappingOrder(
      {
        store,
        present: async () => ({ topics: await topics(), addresses: seen.list() }),
        onSaved: (author) => apply(`by ${author === '' ? 'an admin' : author}`),
      },
      order,
    ),
  );

  return {
    client,
    async close() {
      unwatch();
      unanswer();
      reports?.();
      const ignore = (): void => undefined;
      await within(systemClock, STOP_TIMEOUT_MS, link?.close().catch(ignore) ?? Promise.resolve());
      await within(systemClock, STOP_TIMEOUT_MS, client.close().catch(ignore));
    },
  };
}

function createBridgeClient({ config, log }: BridgeSettings, system: string): UbiiClient {
  return createClient({
    url: config.master,
    name: config.name,
    publishIntervalMs: 0,
    description: `Connects topics with ${system}`,
    tags: ['bridge', bridgeTag(system)],
    // As a node, it is told which topics end [TD-42]; it runs no modules.
    node: { acceptsWork: false, isBridge: true },
    onError: (error, source) => log('error', `Error in ${source}: ${messageOf(error)}`),
    ...(config.join === undefined ? {} : { joinToken: config.join }),
    identity: identityOf(config),
  });
}

function identityOf({ identity, master, name }: Config): IdentityStorage {
  if (identity === 'off') return createMemoryIdentity();
  return createIdentityFile(identity ?? defaultIdentityFile('bridges', master, name));
}

function describeStore({ file, path, fileExists }: MappingStore): string {
  if (!fileExists) {
    return `No mappings yet: ${path} does not exist. The page Bridges of the master creates it`;
  }
  const discovery = file.homeAssistant === undefined ? '' : ' and discovery of Home Assistant';
  return `${counted(file.mappings.length, 'mapping')}${discovery} in ${path}`;
}

function warnOfRestart(before: MappingFile, next: MappingFile, log: Log): void {
  const fixed = ({ system, availability, homeAssistant }: MappingFile): string =>
    JSON.stringify([system, availability, homeAssistant]);
  if (fixed(before) === fixed(next)) return;
  log('warn', 'Changes of system, availability and homeAssistant apply from the next start.');
}

/** Logs the connection to the other system; of several failed attempts, the first. */
function createSystemLog(log: Log, { url }: Target): (state: ForeignState) => void {
  let logged = '';
  return (state) => {
    const text = `${state.status} ${'reason' in state ? state.reason : ''}`;
    if (text === logged) return;
    logged = text;
    if (state.status === 'connected') log('info', `Connected to ${url}`);
    else if (state.status === 'waiting') {
      log('warn', `No connection to ${url}: ${state.reason}. Retrying until it succeeds`);
    }
  };
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
