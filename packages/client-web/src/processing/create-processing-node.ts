import { compilerOf, lazyPatterns, type PatternSource } from '@ubii/patterns';
import { ModuleEventKind, NodeExtensionKind } from '@ubii/proto';
import type { Init, ModuleEvent, ProcessingModule, Session } from '@ubii/proto';
import { createModuleRuntime } from '@ubii/pm-sandbox';
import type { ModuleFault, ModuleRuntime } from '@ubii/pm-sandbox';
import type { Clock } from '@ubii/timing';
import { systemClock } from '@ubii/timing/system';
import { Listeners } from '../core/callbacks/listeners.ts';
import type { UbiiClient, Unsubscribe } from '../core/client/ubii-client.ts';
import { ClientTopicPort } from './client-topic-port.ts';
import { DeviceTopics } from './device-topics.ts';
import { InstanceKeeper } from './instance-keeper.ts';
import { runShare } from './lockstep-shares.ts';
import { ModuleCatalog } from './module-catalog.ts';
import { ModuleReports } from './module-reports.ts';
import type { NodeInstance } from './node-instance.ts';
import type { ProcessingNode, ProcessingNodeOptions } from './processing-node.ts';
import { activityOf, modulesFor } from './session-modules.ts';
import type { AssignedModule, SessionActivity } from './session-modules.ts';
import { SessionWatch } from './session-watch.ts';
import { createPageClock } from './page-clock.ts';
import { inMasterTime } from './in-master-time.ts';

/** How often statistics are reported, milliseconds. [PM-80] */
export const STATISTICS_INTERVAL_MS = 250;

/** A node on the given client, which may be connected or not. Does nothing before `start()`. */
export function createProcessingNode(
  client: UbiiClient,
  options: ProcessingNodeOptions,
): ProcessingNode {
  return new Node(client, options);
}

class Node implements ProcessingNode {
  readonly #client: UbiiClient;
  readonly #options: ProcessingNodeOptions;
  readonly #clock: Clock;
  readonly #patterns: PatternSource;
  readonly #devices: DeviceTopics;
  readonly #reports: ModuleReports;
  readonly #keepers = new Map<string, InstanceKeeper>();
  readonly #changeListeners: Listeners<readonly NodeInstance[]>;
  readonly #eventListeners: Listeners<ModuleEvent>;
  #catalog: ModuleCatalog;
  #acceptsWork: boolean;
  /** From the first module on, and as long as the client has the same id. */
  #runtime: ModuleRuntime | undefined;
  /** Ends everything that `start` began. */
  #started: { readonly watch: SessionWatch; end(): void } | undefined;
  /** Settles with the last of `start` and `stop`. */
  #changed: Promise<void> = Promise.resolve();
  #cancelStatistics: (() => void) | undefined;
  #isChanging = false;
  /** The connection is new: the master may have forgotten what was reported. [PM-63] */
  #mustReportAgain = false;

  constructor(client: UbiiClient, options: ProcessingNodeOptions) {
    this.#client = client;
    this.#options = options;
    this.#changeListeners = new Listeners(client.reportError);
    this.#eventListeners = new Listeners(client.reportError);
    const clock = options.clock ?? (options.kind === 'browser' ? createPageClock() : systemClock);
    // All nodes stamp the records of modules with the same clock. [TS-9]
    this.#clock = inMasterTime(clock, client.masterTime);
    this.#patterns = options.patterns ?? lazyPatterns();
    this.#catalog = new ModuleCatalog(options.modules ?? []);
    this.#acceptsWork = options.acceptsWork ?? true;
    this.#devices = new DeviceTopics(client);
    this.#reports = new ModuleReports(client, {
      handleUnknown: () => this.#started?.watch.refresh(),
    });
  }

  get isStarted(): boolean {
    return this.#started !== undefined;
  }

  get instances(): readonly NodeInstance[] {
    return [...this.#keepers.values()].map(({ shown }) => shown);
  }

  onChange(fn: (instances: readonly NodeInstance[]) => void): Unsubscribe {
    return this.#changeListeners.add(fn);
  }

  onEvent(fn: (event: ModuleEvent) => void): Unsubscribe {
    return this.#eventListeners.add(fn);
  }

  start(): Promise<void> {
    return this.#inTurn(() => this.#start());
  }

  stop(): Promise<void> {
    return this.#inTurn(() => this.#stop());
  }

  /** One at a time: who starts while it stops means it to be started. */
  #inTurn(change: () => Promise<void>): Promise<void> {
    const changed = this.#changed.then(change);
    this.#changed = changed.catch(() => undefined);
    return changed;
  }

  async #start(): Promise<void> {
    if (this.#started !== undefined) return;
    // Before anything else is said: the master takes node messages only from nodes. [EX-20]
    await this.#tellProfile(true);
    const watch = new SessionWatch(this.#client, {
      handleSession: (session, activity) => this.#handleSession(session, activity),
      handleStart: (session) => {
        this.#handleSession(session, 'active');
        this.#reportAgain(({ sessionId }) => sessionId === session.id);
      },
      handleAll: (sessions) => this.#handleAll(sessions),
    });
    const stopMessages = this.#client.onNodeMessage(({ lockstepRequest }) => {
      if (lockstepRequest === undefined) return;
      void runShare(lockstepRequest, this.#runtime).then((frame) =>
        this.#client.sendNodeMessage(frame),
      );
    });
    const stopState = this.#client.onState(({ status }) => {
      if (status !== 'connected') return;
      this.#mustReportAgain = true;
      this.#reports.resume();
    });
    const stopIdentity = this.#client.onIdentityChange(() => void this.#endAll());
    this.#started = {
      watch,
      end: () => {
        watch.close();
        stopMessages();
        stopState();
        stopIdentity();
      },
    };
  }

  async #stop(): Promise<void> {
    const started = this.#started;
    if (started === undefined) return;
    this.#started = undefined;
    started.end();
    await this.#endAll();
    await this.#reports.settled();
    await this.#tellProfile(false);
  }

  async setModules(modules: readonly Init<ProcessingModule>[]): Promise<void> {
    this.#catalog = new ModuleCatalog(modules);
    if (this.isStarted) await this.#tellProfile(true);
  }

  async setAcceptsWork(acceptsWork: boolean): Promise<void> {
    this.#acceptsWork = acceptsWork;
    if (this.isStarted) await this.#tellProfile(true);
  }

  /** [PM-60] */
  #tellProfile(isNode: boolean): Promise<void> {
    const { kind, libraries = [], capacity = 0, isDedicated = false } = this.#options;
    const { assets, sandboxes } = this.#options;
    return this.#client.updateProfile({
      node: isNode
        ? {
            kind: kind === 'browser' ? NodeExtensionKind.BROWSER : NodeExtensionKind.NODE,
            runsJavascript: true,
            acceptsWork: this.#acceptsWork,
            libraries: [...libraries],
            loadsAssets: assets !== undefined,
            capacity,
            memoryBytes: sandboxes.memory?.limitBytes ?? 0,
          }
        : undefined,
      processingModules: isNode ? this.#catalog.offers() : [],
      isDedicatedNode: isNode && isDedicated,
    });
  }

  #handleSession(session: Session, activity: SessionActivity): void {
    const assigned = modulesFor(session, this.#client.id, activity);
    const ids = new Set(assigned.map(({ module }) => module.id));
    for (const keeper of this.#keepers.values()) {
      if (keeper.sessionId === session.id && !ids.has(keeper.id)) keeper.unwant();
    }
    for (const module of assigned) this.#want(module);
  }

  #handleAll(sessions: readonly Session[]): void {
    const known = new Set(sessions.map(({ id }) => id));
    for (const keeper of this.#keepers.values()) {
      if (!known.has(keeper.sessionId)) keeper.unwant();
    }
    for (const session of sessions) {
      const activity = activityOf(session);
      if (activity !== undefined) this.#handleSession(session, activity);
    }
    if (!this.#mustReportAgain) return;
    this.#mustReportAgain = false;
    this.#reportAgain(() => true);
  }

  #reportAgain(isMeant: (keeper: InstanceKeeper) => boolean): void {
    for (const keeper of this.#keepers.values()) {
      if (keeper.reported !== undefined && isMeant(keeper)) this.#reports.started(keeper.reported);
    }
  }

  #want(assigned: AssignedModule): void {
    const { id } = assigned.module;
    let keeper = this.#keepers.get(id);
    if (keeper === undefined) {
      keeper = this.#createKeeper(id);
      this.#keepers.set(id, keeper);
    }
    keeper.want(assigned);
  }

  #createKeeper(id: string): InstanceKeeper {
    return new InstanceKeeper(id, {
      runtime: this.#runtimeNow(),
      patterns: this.#patterns,
      catalog: () => this.#catalog,
      handleStarted: (assigned) => this.#reports.started(assigned),
      handleEnded: (assigned) => this.#reports.ended(assigned),
      handleFailed: (assigned, fault) => this.#handleFailed(assigned, fault),
      handleChange: () => this.#handleChange(),
    });
  }

  #runtimeNow(): ModuleRuntime {
    if (this.#runtime !== undefined) return this.#runtime;
    const { sandboxes, libraries, assets, limits } = this.#options;
    const { createRuntime = createModuleRuntime } = this.#options;
    this.#runtime = createRuntime({
      nodeId: this.#client.id,
      clock: this.#clock,
      topics: new ClientTopicPort(this.#client, this.#devices),
      patterns: compilerOf(this.#patterns),
      sandboxes,
      libraries,
      assets,
      limits,
      lockstepInputs: 'given', // the master sends the snapshots [SE-40]
      onEvent: (event) => this.#handleEvent(event),
      onStatus: (id, status, fault) => this.#keepers.get(id)?.handleStatus(status, fault),
    });
    this.#cancelStatistics = this.#clock.every(STATISTICS_INTERVAL_MS, () =>
      this.#reportStatistics(),
    );
    return this.#runtime;
  }

  #reportStatistics(): void {
    this.#reports.resume(); // what did not get through, though the connection holds
    const statistics = this.#runtime?.statistics() ?? [];
    if (statistics.length === 0) return;
    for (const entry of statistics) this.#keepers.get(entry.moduleId)?.handleStatistics(entry);
    this.#reports.statistics(statistics);
  }

  #handleEvent(event: ModuleEvent): void {
    this.#reports.event(event);
    this.#eventListeners.emit(event);
  }

  /** Reports an instance that could not be created: only this node can notify the session. [SE-12] */
  #handleFailed({ module, sessionId }: AssignedModule, fault: ModuleFault): void {
    this.#handleEvent({
      sessionId,
      moduleId: module.id,
      moduleName: module.name,
      nodeId: this.#client.id,
      kind: ModuleEventKind.FAILED,
      timeMs: this.#clock.nowMs(),
      phase: fault.phase,
      message: fault.message,
      line: fault.line ?? 0,
      column: fault.column ?? 0,
      level: '',
      suppressed: 0,
    });
  }

  /** What runs under the client's id of now, or of before, ends; what comes later is made again. */
  async #endAll(): Promise<void> {
    const keepers = [...this.#keepers.values()];
    const runtime = this.#runtime;
    this.#keepers.clear();
    this.#runtime = undefined;
    this.#cancelStatistics?.();
    this.#cancelStatistics = undefined;
    for (const keeper of keepers) keeper.unwant();
    this.#handleChange();
    await Promise.all(keepers.map((keeper) => keeper.settled()));
    await runtime?.close();
  }

  #handleChange(): void {
    if (this.#isChanging) return;
    this.#isChanging = true;
    void Promise.resolve().then(() => {
      this.#isChanging = false;
      for (const keeper of [...this.#keepers.values()]) {
        if (keeper.isGone) this.#keepers.delete(keeper.id);
      }
      this.#changeListeners.emit(this.instances);
    });
  }
}
