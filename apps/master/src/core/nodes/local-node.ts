import {
  InstanceKeeper,
  type ModuleFault,
  type ModuleRuntime,
  type WantedInstance,
} from '@ubii/pm-sandbox';
import { ProcessingModuleStatus, type ModuleEvent, type ModuleStatistics } from '@ubii/proto';
import { Hook } from '../hooks/hook.ts';

/** Callbacks of a runtime for its node. */
export interface RuntimeHooks {
  onEvent(event: ModuleEvent): void;
  onStatus(instanceId: string, status: ProcessingModuleStatus, fault?: ModuleFault): void;
}

/**
 * The master as a node: keeps the instances of sessions as those want them, and tells how it went. The runtime is made
 * when the first module comes.
 */
export class LocalNode {
  readonly onStarted = new Hook<[moduleId: string]>();
  readonly onStopped = new Hook<[moduleId: string]>();
  /** Called when a module could not be started, was killed, or was given up. */
  readonly onFailed = new Hook<[moduleId: string, reason: string, fault: ModuleFault]>();
  readonly onEvent = new Hook<[event: ModuleEvent]>();
  readonly #instances: InstanceKeeper;
  #runtime: ModuleRuntime | undefined = undefined;

  constructor(createRuntime: (hooks: RuntimeHooks) => ModuleRuntime) {
    const hooks: RuntimeHooks = {
      onEvent: (event) => this.onEvent.emit(event),
      onStatus: (id, status, fault) => this.#handleStatus(id, status, fault),
    };
    this.#instances = new InstanceKeeper({
      runtime: () => (this.#runtime ??= createRuntime(hooks)),
      onStarted: ({ spec }) => this.onStarted.emit(spec.module.id),
      onEnded: ({ spec }, isWanted) => {
        if (!isWanted) this.onStopped.emit(spec.module.id);
      },
      onFailed: ({ spec }, fault) => this.onFailed.emit(spec.module.id, fault.message, fault),
    });
  }

  /** Undefined as long as no module ran here. */
  get runtime(): ModuleRuntime | undefined {
    return this.#runtime;
  }

  get instanceCount(): number {
    return this.#runtime?.instanceCount ?? 0;
  }

  /** These are the modules of this session that run here from now on; all others of it end. */
  sync(sessionId: string, wanted: readonly WantedInstance[]): void {
    this.#instances.sync(sessionId, wanted);
  }

  /** Whether there is an instance of it, or one is being made. */
  isBusyWith(moduleId: string): boolean {
    return this.#instances.has(moduleId);
  }

  statistics(): ModuleStatistics[] {
    return this.#runtime?.statistics() ?? [];
  }

  async close(): Promise<void> {
    this.#instances.close();
    await this.#runtime?.close();
  }

  #handleStatus(id: string, status: ProcessingModuleStatus, fault: ModuleFault | undefined): void {
    if (!this.#instances.handleStatus(id, status, fault)) return;
    if (fault !== undefined) this.onFailed.emit(id, fault.message, fault);
    else if (status === ProcessingModuleStatus.PROCESSING) this.onStarted.emit(id);
  }
}
