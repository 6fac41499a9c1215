import { createClient } from '@ubii/client-web/node';
import type { ConnectionError, ConnectionState, UbiiClient } from '@ubii/client-web/node';
import { createProcessingNode } from '@ubii/client-web/processing';
import type { NodeInstance, ProcessingNode } from '@ubii/client-web/processing';
import { moduleLibrary } from '@ubii/modules';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { watchModuleFolder } from '@ubii/pm-sandbox/folder';
import type { FolderWatch, LoadedFolder } from '@ubii/pm-sandbox/folder';
import { ModuleEventKind } from '@ubii/proto';
import type { ModuleEvent, ProcessingModule } from '@ubii/proto';
import { createIdentityFile, defaultIdentityFile } from './identity-file.ts';
import type { Log } from './log.ts';
import type { Config, LogLevel } from './options.ts';
import { ConfigError } from './read-config.ts';

/** How long leaving the master may take, milliseconds: with what the process needs, 2 s in all. */
const STOP_TIMEOUT_MS = 800;

/** What a node is started with. */
export interface NodeSetup {
  readonly config: Config;
  readonly sandboxes: SandboxFactory;
  /** Names of the libraries the sandboxes offer. */
  readonly libraries: readonly string[];
  readonly log: Log;
}

/** A node that takes part, or tries to. */
export interface RunningNode {
  readonly client: UbiiClient;
  readonly node: ProcessingNode;
  /** Ends all modules and leaves the master; gives up on what takes too long. */
  close(): Promise<void>;
}

/**
 * Starts a node. Resolves as soon as it has begun to connect; it never gives that up.
 * @throws ConfigError when the folder of modules cannot be read
 */
export async function startNode({
  config,
  sandboxes,
  libraries,
  log,
}: NodeSetup): Promise<RunningNode> {
  const own = moduleLibrary().filter((module) => isRunnable(module, libraries));
  let folder: FolderWatch | undefined;
  const client = createClient({
    url: config.master,
    name: config.name,
    tags: ['processing-node'],
    publishIntervalMs: 0,
    ...(config.join === undefined ? {} : { joinToken: config.join }),
    ...(config.identity === 'off'
      ? {}
      : {
          identity: createIdentityFile(
            config.identity ?? defaultIdentityFile(config.master, config.name),
          ),
        }),
  });
  const node = createProcessingNode(client, {
    kind: 'node',
    isDedicated: true,
    sandboxes,
    libraries,
    capacity: config.capacity,
    acceptsWork: !config.noAcceptWork,
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

  client.onState(createStateLog(log, config.master));
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
      await within(STOP_TIMEOUT_MS, node.stop());
      await within(STOP_TIMEOUT_MS, client.close());
    },
  };
}

/** Modules that need what this node does not have would only be offered in vain. [PM-4] */
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
      log('error', `${folder} is no longer watched: ${error.message}`),
    );
  } catch (error) {
    throw new ConfigError(
      `The folder given by --modules, ${folder}, must be readable, but: ${messageOf(error)}.`,
    );
  }
}

/** The client connects by itself; only when somebody else uses its identity it stops. */
function keepConnecting(client: UbiiClient, log: Log): void {
  client.connect().catch((error: unknown) => {
    log('error', `The node stopped trying to connect: ${messageOf(error)}`);
  });
}

function describeModules(modules: readonly ProcessingModule[]): string {
  const names = modules.map(({ name }) => name).join(', ');
  return modules.length === 0 ? 'No modules' : `${modules.length} modules (${names})`;
}

/** Tells how the connection is; of the attempts to get it back only the first. */
function createStateLog(log: Log, master: string): (state: ConnectionState) => void {
  let isTold = false;
  return (state) => {
    switch (state.status) {
      case 'connected':
        isTold = false;
        return log('info', `Connected to ${master} as ${state.clientId}`);
      case 'reconnecting':
        if (isTold) return log('debug', `Attempt ${state.attempt}: ${state.error.message}`);
        isTold = true;
        return log(
          'warn',
          `No connection to ${master}: ${state.error.message}. Trying again until it succeeds`,
        );
      case 'closed':
        return state.error === undefined
          ? log('info', `Left ${master}`)
          : log(
              'error',
              `${master} refused this node: ${state.error.message}${hintFor(state.error)}`,
            );
      case 'connecting':
        return log('info', `Connecting to ${master}`);
      case 'idle':
        return;
    }
  };
}

function hintFor({ reason }: ConnectionError): string {
  return reason === 'join' ? ' Start it with --join <code>, from the terminal of the master.' : '';
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

/** Tells which modules came and went. */
function createInstanceLog(log: Log): (instances: readonly NodeInstance[]) => void {
  let known = new Map<string, string>();
  return (instances) => {
    const now = new Map(
      instances.map(({ id, moduleName, sessionName }) => [id, `${moduleName} of ${sessionName}`]),
    );
    for (const [id, text] of now) if (!known.has(id)) log('info', `Runs ${text}`);
    for (const [id, text] of known) if (!now.has(id)) log('info', `Ended ${text}`);
    known = now;
  };
}

async function within(timeoutMs: number, work: Promise<unknown>): Promise<void> {
  let timer: NodeJS.Timeout | undefined;
  await Promise.race([
    work.catch(() => undefined), // the master is gone: left either way
    new Promise((resolve) => (timer = setTimeout(resolve, timeoutMs))),
  ]);
  clearTimeout(timer);
}

function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
