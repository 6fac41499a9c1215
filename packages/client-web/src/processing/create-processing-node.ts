import { compilerOf, lazyPatterns, type PatternSource } from '@ubii/patterns';
import { ModuleEventKind, NodeExtensionKind } from '@ubii/proto';
import type { Init, ModuleEvent, ProcessingModule, Session } from '@ubii/proto';
import { createModuleRuntime } from '@ubii/pm-sandbox';
import type { ModuleFault, ModuleRuntime, WantedInstance } from '@ubii/pm-sandbox';
import type { Clock } from '@ubii/timing';
import { systemClock } from '@ubii/timing/system';
import { Listeners } from '../core/callbacks/listeners.ts';
import type { UbiiClient, Unsubscribe } from '../core/client/ubii-client.ts';
import { ClientTopicPort } from './client-topic-port.ts';
import { DeviceTopics } from './device-topics.ts';
import { runShare } from './lockstep-shares.ts';
import { ModuleCatalog } from './module-catalog.ts';
import { ModuleReports } from './module-reports.ts';
import type { NodeInstance } from './node-instance.ts';
import { NodeInstances } from './node-instances.ts';
import type { RuntimeEvents } from './node-instances.ts';
import type { ProcessingNode, ProcessingNodeOptions } from './processing-node.ts';
import { activityOf, instancesFor, outputTopics, outputTopicsOf } from './session-modules.ts';
import type { SessionActivity } from './session-modules.ts';
import { SessionWatch } from './session-watch.ts';
import { createPageClock } from './page-clock.ts';
import { inMasterTime } from './in-master-time.ts';

/** Interval of statistics reports, milliseconds. [PM-80] */
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
  readonly #topics: ClientTopicPort;
  readonly #reports: ModuleReports;
  readonly #changeListeners: Listeners<readonly NodeInstance[]>;
  readonly #eventListeners: Listeners<ModuleEvent>;
  #catalog: ModuleCatalog;
  #acceptsWork: boolean;
  /** From the first module on, and as long as the client has the same id. */
  #instances: NodeInstances | undefined;
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
    this.#topics = new ClientTopicPort(client, this.#devices);
    this.#reports = new ModuleReports(client, {
      handleUnknown: () => this.#started?.watch.refresh(),
    });
  }

  get isStarted(): boolean {
    return this.#started !== undefined;
  }

  get instances(): readonly NodeInstance[] {
    return this.#instances?.shown ?? [];
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
    // First: the master accepts node messages only from nodes. [EX-20]
    await this.#sendProfile(true);
    const watch = new SessionWatch(this.#client, {
      handleSession: (session, activity) => this.#handleSession(session, activity),
      handleStart: (session) => {
        this.#handleSession(session, 'active');
        this.#reportAgain(({ spec }) => spec.module.sessionId === session.id);
      },
      handleDeleted: (session) => void this.#handleDeleted(session),
      handleAll: (sessions) => this.#handleAll(sessions),
    });
    const stopMessages = this.#client.onNodeMessage(({ lockstepRequest }) => {
      if (lockstepRequest === undefined) return;
      void runShare(lockstepRequest, this.#instances?.runtime).then((frame) =>
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
    await this.#sendProfile(false);
  }

  async setModules(modules: readonly Init<ProcessingModule>[]): Promise<void> {
    this.#catalog = new ModuleCatalog(modules);
    if (this.isStarted) await this.#sendProfile(true);
  }

  async setAcceptsWork(acceptsWork: boolean): Promise<void> {
    this.#acceptsWork = acceptsWork;
    if (this.isStarted) await this.#sendProfile(true);
  }

  /** [PM-60] */
  #sendProfile(isNode: boolean): Promise<void> {
    const { kind, libraries = [], capacity = 0, isDedicated = false } = this.#options;
    const { assets, sandboxes, records = false } = this.#options;
    return this.#client.updateProfile({
      node: isNode
        ? {
            kind: kind === 'browser' ? NodeExtensionKind.BROWSER : NodeExtensionKind.NODE,
            runsJavascript: true,
            acceptsWork: this.#acceptsWork,
            libraries: [...libraries],
            loadsAssets: assets !== undefined,
            records,
            capacity,
            memoryBytes: sandboxes.memory?.limitBytes ?? 0,
          }
        : undefined,
      processingModules: isNode ? this.#catalog.offers() : [],
      isDedicatedNode: isNode && isDedicated,
    });
  }

  #handleSession(session: Session, activity: SessionActivity): void {
    const wanted = instancesFor(session, this.#client.id, activity, this.#catalog);
    if (wanted.length > 0) this.#instances ??= this.#createInstances();
    this.#instances?.sync(session, wanted);
  }

  /** Topics that outputs were mapped to by name end with the session, unless another one writes them. [SE-63] */
  async #handleDeleted(session: Session): Promise<void> {
    this.#handleSession(session, 'over');
    await this.#instances?.settled();
    const written = this.#instances?.started.flatMap(({ spec }) => outputTopics(spec.mapping));
    if (written === undefined) return;
    const ended = outputTopicsOf(session, this.#client.id).filter((one) => !written.includes(one));
    if (ended.length > 0) this.#topics.endTopics(ended);
  }

  #handleAll(sessions: readonly Session[]): void {
    this.#instances?.keepSessions(new Set(sessions.map(({ id }) => id)));
    for (const session of sessions) {
      const activity = activityOf(session);
      if (activity !== undefined) this.#handleSession(session, activity);
    }
    if (!this.#mustReportAgain) return;
    this.#mustReportAgain = false;
    this.#reportAgain(() => true);
  }

  #reportAgain(isMeant: (wanted: WantedInstance) => boolean): void {
    for (const wanted of this.#instances?.started ?? []) {
      if (isMeant(wanted)) this.#reports.started(wanted);
    }
  }

  #createInstances(): NodeInstances {
    this.#cancelStatistics = this.#clock.every(STATISTICS_INTERVAL_MS, () =>
      this.#reportStatistics(),
    );
    return new NodeInstances({
      patterns: this.#patterns,
      createRuntime: (events) => this.#createRuntime(events),
      handleStarted: (wanted) => this.#reports.started(wanted),
      handleEnded: (wanted) => this.#reports.ended(wanted),
      handleFailed: (wanted, fault) => this.#handleFailed(wanted, fault),
      handleEvent: (event) => this.#handleEvent(event),
      handleChange: () => this.#handleChange(),
    });
  }

  #createRuntime(events: RuntimeEvents): ModuleRuntime {
    const { sandboxes, libraries, assets, limits } = this.#options;
    const { createRuntime = createModuleRuntime } = this.#options;
    return createRuntime({
      nodeId: this.#client.id,
      clock: this.#clock,
      topics: this.#topics,
      patterns: compilerOf(this.#patterns),
      sandboxes,
      libraries,
      assets,
      limits,
      lockstepInputs: 'given', // the master sends the snapshots [SE-40]
      ...events,
    });
  }

  #reportStatistics(): void {
    this.#reports.resume(); // what did not get through, though the connection holds
    const statistics = this.#instances?.takeStatistics() ?? [];
    if (statistics.length > 0) this.#reports.statistics(statistics);
  }

  #handleEvent(event: ModuleEvent): void {
    this.#reports.event(event);
    this.#eventListeners.emit(event);
  }

  /** Reports an instance that could not be created: only this node can notify the session. [SE-12] */
  #handleFailed({ spec }: WantedInstance, fault: ModuleFault): void {
    const { sessionId, id: moduleId, name: moduleName } = spec.module;
    this.#handleEvent({
      sessionId,
      moduleId,
      moduleName,
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

  /** Ends instances under the current or a previous client id; later ones are created again. */
  async #endAll(): Promise<void> {
    const instances = this.#instances;
    this.#instances = undefined;
    this.#cancelStatistics?.();
    this.#cancelStatistics = undefined;
    this.#handleChange();
    await instances?.end();
  }

  #handleChange(): void {
    if (this.#isChanging) return;
    this.#isChanging = true;
    void Promise.resolve().then(() => {
      this.#isChanging = false;
      this.#changeListeners.emit(this.instances);
    });
  }
}
