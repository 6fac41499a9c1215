import { ConfigError, findBuilt } from '@ubii/program';
import type { LogLevel } from '@ubii/program';
import { createStateLog } from '@ubii/client-program';
import type { Log } from '@ubii/client-program';
import {
  createClient,
  createIdentityFile,
  createMemoryIdentity,
  defaultIdentityFile,
} from '@ubii/client-web/node';
import type { IdentityStorage, UbiiClient } from '@ubii/client-web/node';
import { createProcessingNode } from '@ubii/client-web/processing';
import type { NodeInstance, ProcessingNode } from '@ubii/client-web/processing';
import { moduleLibrary } from '@ubii/modules';
import { partyModules } from '@ubii/party/modules';
import { createAssetStore, createHttpAssets } from '@ubii/pm-sandbox';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { watchModuleFolder } from '@ubii/pm-sandbox/folder';
import type { FolderWatch, LoadedFolder } from '@ubii/pm-sandbox/folder';
import { ModuleEventKind } from '@ubii/proto';
import type { ModuleEvent, ProcessingModule } from '@ubii/proto';
import { within } from '@ubii/timing';
import { systemClock } from '@ubii/timing/system';
import { counted } from '@ubii/words';
import type { Config } from './options.ts';
import { openRecorder, watchCredential } from './recorder/open-recorder.ts';

/** Time for each step of the shutdown, milliseconds. With the exit of the process, it takes 2 s at most. */
const STOP_TIMEOUT_MS = 800;

/** Arguments of `startNode`. */
export interface NodeSetup {
  readonly config: Config;
  readonly sandboxes: SandboxFactory;
  /** Names of the libraries of the sandboxes. */
  readonly libraries: readonly string[];
  readonly log: Log;
}

/** A node that is connected or connecting. */
export interface RunningNode {
  readonly client: UbiiClient;
  readonly node: ProcessingNode;
  /** Stops all modules and deregisters. Resolves after at most two `STOP_TIMEOUT_MS`. */
  close(): Promise<void>;
}

/**
 * Starts a node. Resolves when it has begun to connect; it tries to connect until it succeeds.
 * @throws ConfigError when the module folder cannot be read
 */
export async function startNode({
  config,
  sandboxes,
  libraries,
  log,
}: NodeSetup): Promise<RunningNode> {
  const own = [...moduleLibrary(), ...partyModules()].filter((module) =>
    isRunnable(module, libraries),
  );
  let folder: FolderWatch | undefined;
  const { identity, credential } = watchCredential(identityOf(config));
  const client = createClient({
    url: config.master,
    name: config.name,
    tags: ['processing-node'],
    publishIntervalMs: 0,
    onError: (error, source) => log('error', `Error in ${source}: ${messageOf(error)}`),
    ...(config.join === undefined ? {} : { joinToken: config.join }),
    identity,
  });
  const masterUrl = (): string => client.masterUrl ?? config.master;
  const recorder =
    config.recordDir === undefined
      ? undefined
      : await openRecorder({
          client,
          log,
          credential,
          master: config.master,
          masterUrl,
          folder: config.recordDir,
          maxBytes: config.recordSpace,
          workerFile: findBuilt('recorder-worker.js', import.meta.url),
          checkProcessFile: findBuilt('check-process.js', import.meta.url),
        });
  const node = createProcessingNode(client, {
    kind: 'node',
    isDedicated: true,
    sandboxes,
    libraries,
    assets: createAssetStore(createHttpAssets(masterUrl)),
    capacity: config.capacity,
    acceptsWork: !config.noAcceptWork,
    records: recorder !== undefined,
  });
  const use = (loaded: LoadedFolder): Promise<void> => {
    for (const { file, message } of loaded.problems) log('error', `${file}: ${message}`);
    const names = new Set(loaded.modules.map(({ name }) => name));
    return node.setModules([...own.filter(({ name }) => !names.has(name)), ...loaded.modules]);
  };
  await node.setModules(own);
  if (config.modules !== undefined) {
    folder = await watchFolder(config.modules, log, (loaded) => {
      log('info', `${describeModules(loaded.modules)} in ${config.modules}`);
      use(loaded).catch((error: unknown) => log('error', messageOf(error)));
    });
    await use(folder.loaded);
    log('info', `${describeModules(folder.loaded.modules)} in ${config.modules}`);
  }

  client.onState(createStateLog(log, masterUrl, 'node'));
  client.onMaster(({ url, previousUrl }) =>
    log('warn', `${previousUrl} was lost. Moved to ${url}`),
  );
  client.onError((problem) => log('warn', problem.message));
  node.onEvent((event) => log(...describeEvent(event)));
  node.onChange(createInstanceLog(log));
  await node.start();
  keepConnecting(client, log);

  return {
    client,
    node,
    async close() {
      folder?.close();
      // A master that is not available: nothing to deregister from.
      const ignore = (): void => undefined;
      const closed = recorder?.close().catch(ignore);
      await within(systemClock, STOP_TIMEOUT_MS, Promise.all([closed, node.stop().catch(ignore)]));
      await within(systemClock, STOP_TIMEOUT_MS, client.close().catch(ignore));
    },
  };
}

function identityOf({ identity, master, name }: Config): IdentityStorage {
  if (identity === 'off') return createMemoryIdentity();
  return createIdentityFile(identity ?? defaultIdentityFile('nodes', master, name));
}

/** True when the node has all libraries of the module. Other modules are not offered. [PM-4] */
function isRunnable({ extension }: ProcessingModule, libraries: readonly string[]): boolean {
  return (extension?.libraries ?? []).every((library) => libraries.includes(library));
}

async function watchFolder(
  folder: string,
  log: Log,
  onChange: (loaded: LoadedFolder) => void,
): Promise<FolderWatch> {
  try {
    return await watchModuleFolder(folder, onChange, (error) =>
      log('error', `Changes in ${folder} are no longer detected: ${error.message}`),
    );
  } catch (error) {
    throw new ConfigError(
      `The module folder ${folder} (--modules) cannot be read: ${messageOf(error)}.`,
    );
  }
}

/** Connects. The client reconnects by itself, and stops only when another client uses its identity. */
function keepConnecting(client: UbiiClient, log: Log): void {
  client.connect().catch((error: unknown) => {
    log('error', `The node no longer tries to connect: ${messageOf(error)}`);
  });
}

function describeModules(modules: readonly ProcessingModule[]): string {
  const names = modules.map(({ name }) => name).join(', ');
  if (modules.length === 0) return 'No modules';
  return `${counted(modules.length, 'module')} (${names})`;
}

const EVENT_LEVELS: { readonly [K in ModuleEventKind]: LogLevel } = {
  [ModuleEventKind.ERROR]: 'warn',
  [ModuleEventKind.LOG]: 'info',
  [ModuleEventKind.KILLED]: 'warn',
  [ModuleEventKind.RESTARTED]: 'info',
  [ModuleEventKind.FAILED]: 'error',
  [ModuleEventKind.REFUSED]: 'warn',
  [ModuleEventKind.OVERRUN]: 'debug',
};

function describeEvent(event: ModuleEvent): [LogLevel, string] {
  const { kind, moduleName, phase, line, message } = event;
  const place = phase === '' ? '' : ` ${phase}${line > 0 ? ` line ${line}` : ''}`;
  return [EVENT_LEVELS[kind], `${moduleName}${place}: ${message}`];
}

/** Logs modules that start and stop. */
function createInstanceLog(log: Log): (instances: readonly NodeInstance[]) => void {
  let known = new Map<string, string>();
  return (instances) => {
    const now = new Map(
      instances.map(({ id, moduleName, sessionName }) => [
        id,
        `module "${moduleName}" of session "${sessionName}"`,
      ]),
    );
    for (const [id, text] of now) if (!known.has(id)) log('info', `Started ${text}`);
    for (const [id, text] of known) if (!now.has(id)) log('info', `Stopped ${text}`);
    known = now;
  };
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
