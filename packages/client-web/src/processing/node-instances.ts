import type { PatternSource } from '@ubii/patterns';
import { ProcessingModuleStatus } from '@ubii/proto';
import type { ModuleEvent, ModuleStatistics, Session } from '@ubii/proto';
import { InstanceKeeper } from '@ubii/pm-sandbox';
import type { ModuleFault, ModuleRuntime, WantedInstance } from '@ubii/pm-sandbox';
import type { NodeInstance } from './node-instance.ts';

/** Events of a runtime for its node. */
export interface RuntimeEvents {
  onEvent(event: ModuleEvent): void;
  onStatus(instanceId: string, status: ProcessingModuleStatus, fault?: ModuleFault): void;
}

/** Dependencies and callbacks of a node's instances. */
export interface NodeInstancesOptions {
  readonly patterns: PatternSource;
  createRuntime(events: RuntimeEvents): ModuleRuntime;
  /** It runs, or is ready to where its session is paused. */
  handleStarted(wanted: WantedInstance): void;
  /** It has ended, or was never made. */
  handleEnded(wanted: WantedInstance): void;
  handleFailed(wanted: WantedInstance, fault: ModuleFault): void;
  handleEvent(event: ModuleEvent): void;
  /** Called when their displayed state changes. */
  handleChange(): void;
}

/** The instances of a node under one id of its client, and their reports. */
export class NodeInstances {
  readonly runtime: ModuleRuntime;
  readonly #keeper: InstanceKeeper;
  readonly #options: NodeInstancesOptions;
  readonly #shown = new Map<string, NodeInstance>();

  constructor(options: NodeInstancesOptions) {
    this.#options = options;
    this.runtime = options.createRuntime({
      onEvent: (event) => options.handleEvent(event),
      onStatus: (id, status, fault) => {
        this.#keeper.handleStatus(id, status, fault);
        this.#show(id, { status, fault });
      },
    });
    this.#keeper = new InstanceKeeper({
      runtime: () => this.runtime,
      patterns: options.patterns,
      onCreate: ({ spec }) =>
        this.#show(spec.module.id, {
          status: ProcessingModuleStatus.INITIALIZED,
          fault: undefined,
          statistics: undefined,
        }),
      onStarted: (wanted) => options.handleStarted(wanted),
      onEnded: (wanted) => {
        this.#show(wanted.spec.module.id, { status: ProcessingModuleStatus.DESTROYED });
        options.handleEnded(wanted);
      },
      onFailed: (wanted, fault) => {
        const { id } = wanted.spec.module;
        this.#show(id, { status: ProcessingModuleStatus.DESTROYED, fault });
        options.handleFailed(wanted, fault);
      },
      onGone: (id) => {
        this.#shown.delete(id);
        options.handleChange();
      },
    });
  }

  /** In the order they came. */
  get shown(): readonly NodeInstance[] {
    return [...this.#shown.values()];
  }

  /** Instances reported as started that are still valid. */
  get started(): readonly WantedInstance[] {
    return this.#keeper.started;
  }

  /** From now on these are the instances of the session. */
  sync({ id: sessionId, name: sessionName }: Session, wanted: readonly WantedInstance[]): void {
    this.#keeper.sync(sessionId, wanted);
    for (const { spec } of wanted) {
      const { id, name: moduleName } = spec.module;
      const known = this.#shown.get(id) ?? NEW;
      this.#shown.set(id, { ...known, id, moduleName, sessionId, sessionName });
      this.#options.handleChange();
    }
  }

  /** Ends the instances of all other sessions. */
  keepSessions(sessionIds: ReadonlySet<string>): void {
    this.#keeper.keepSessions(sessionIds);
  }

  /** Resolves when no instance is being started or ended. */
  settled(): Promise<void> {
    return this.#keeper.settled();
  }

  takeStatistics(): readonly ModuleStatistics[] {
    const all = this.runtime.statistics();
    for (const statistics of all) this.#show(statistics.moduleId, { statistics });
    return all;
  }

  /** Ends all instances. */
  async end(): Promise<void> {
    this.keepSessions(new Set());
    await this.settled();
    await this.runtime.close();
  }

  #show(id: string, change: Partial<NodeInstance>): void {
    const known = this.#shown.get(id);
    if (known === undefined) return;
    this.#shown.set(id, { ...known, ...change });
    this.#options.handleChange();
  }
}

const NEW = {
  status: ProcessingModuleStatus.INITIALIZED,
  fault: undefined,
  statistics: undefined,
};
