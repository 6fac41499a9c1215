import type { InstanceSpec, ModuleFault, ModuleRuntime } from '@ubii/pm-sandbox';
import {
  encode,
  ProcessingModuleStatus,
  type IOMapping,
  type ModuleEvent,
  type ModuleStatistics,
  type ProcessingMode,
  type ProcessingModule,
} from '@ubii/proto';
import { Hook } from '../hooks/hook.ts';
import { hasCodeOf } from '../library/module-offer.ts';

/** Callbacks of a runtime for its node. */
export interface RuntimeHooks {
  onEvent(event: ModuleEvent): void;
  onStatus(instanceId: string, status: ProcessingModuleStatus, fault?: ModuleFault): void;
}

interface Want {
  readonly spec: InstanceSpec;
  readonly isPaused: boolean;
}

interface Instance {
  readonly id: string;
  sessionId: string;
  /** Wanted module; undefined: none. */
  want: Want | undefined;
  /** Current module. */
  have: Want | undefined;
  /** Module that could not be created. */
  failed: Want | undefined;
  isBusy: boolean;
  /** Its runtime has given it up. */
  isGivenUp: boolean;
  /** It is to be made again, though nothing of it changed. */
  isStale: boolean;
}

/**
 * The master as a node: makes the instances of a session what the session says, one step at a time for
 * each, and tells how it went. The runtime is made when the first module comes.
 */
export class LocalNode {
  readonly onStarted = new Hook<[moduleId: string]>();
  readonly onStopped = new Hook<[moduleId: string]>();
  /** Called when a module could not be started, was killed, or was given up. */
  readonly onFailed = new Hook<
    [moduleId: string, reason: string, fault: ModuleFault | undefined]
  >();
  readonly onEvent = new Hook<[event: ModuleEvent]>();
  readonly #createRuntime: (hooks: RuntimeHooks) => ModuleRuntime;
  readonly #instances = new Map<string, Instance>();
  #runtime: ModuleRuntime | undefined = undefined;
  #isClosed = false;

  constructor(createRuntime: (hooks: RuntimeHooks) => ModuleRuntime) {
    this.#createRuntime = createRuntime;
  }

  /** Undefined as long as no module ran here. */
  get runtime(): ModuleRuntime | undefined {
    return this.#runtime;
  }

  get instanceCount(): number {
    return this.#runtime?.instanceCount ?? 0;
  }

  /** These are the modules of this session that run here from now on; all others of it end. */
  sync(sessionId: string, specs: readonly InstanceSpec[], isPaused: boolean): void {
    const wanted = new Set<string>();
    for (const spec of specs) {
      const { id } = spec.module;
      wanted.add(id);
      let instance = this.#instances.get(id);
      if (instance === undefined) {
        instance = {
          id,
          sessionId,
          want: undefined,
          have: undefined,
          failed: undefined,
          isBusy: false,
          isGivenUp: false,
          isStale: false,
        };
        this.#instances.set(id, instance);
      }
      instance.sessionId = sessionId;
      instance.want = keepIfEqual({ spec, isPaused }, instance.want);
      this.#settle(instance);
    }
    for (const instance of this.#instances.values()) {
      if (instance.sessionId !== sessionId || wanted.has(instance.id)) continue;
      instance.want = undefined;
      instance.failed = undefined;
      this.#settle(instance);
    }
  }

  /** Whether there is an instance of it, or one is being made. */
  isBusyWith(moduleId: string): boolean {
    const instance = this.#instances.get(moduleId);
    if (instance === undefined) return false;
    return instance.have !== undefined || (instance.isBusy && instance.failed === undefined);
  }

  /** Forgets a failure: the next `sync` tries again. */
  retry(moduleId: string): void {
    const instance = this.#instances.get(moduleId);
    if (instance === undefined) return;
    instance.failed = undefined;
    instance.isStale = instance.isGivenUp;
  }

  statistics(): ModuleStatistics[] {
    return this.#runtime?.statistics() ?? [];
  }

  async close(): Promise<void> {
    this.#isClosed = true;
    await this.#runtime?.close();
  }

  #settle(instance: Instance): void {
    if (instance.isBusy || this.#isClosed) return;
    instance.isBusy = true;
    void this.#work(instance).finally(() => {
      instance.isBusy = false;
      if (instance.have === undefined && instance.want === undefined) {
        this.#instances.delete(instance.id);
      }
    });
  }

  async #work(instance: Instance): Promise<void> {
    for (;;) {
      const { want, have, failed } = instance;
      if (want === have && !instance.isStale) return;
      if (have === undefined && want === failed) return;
      if (have === undefined) await this.#create(instance, want!);
      else if (want === undefined || instance.isStale || needsRestart(have, want)) {
        await this.#destroy(instance);
      } else await this.#change(instance, have, want);
      if (this.#isClosed) return;
    }
  }

  async #create(instance: Instance, want: Want): Promise<void> {
    const runtime = (this.#runtime ??= this.#createRuntime({
      onEvent: (event) => this.onEvent.emit(event),
      onStatus: (id, status, fault) => this.#handleStatus(id, status, fault),
    }));
    instance.failed = undefined;
    instance.isStale = false;
    instance.isGivenUp = false;
    try {
      await runtime.create(want.spec);
    } catch (thrown) {
      instance.failed = want;
      const fault = isFault(thrown) ? thrown : undefined;
      this.onFailed.emit(instance.id, fault?.message ?? String(thrown), fault);
      return;
    }
    instance.have = want;
    // The instance is not wanted any more: the next step ends it.
    if (instance.want === undefined) return;
    if (!want.isPaused) runtime.start(instance.id);
    this.onStarted.emit(instance.id);
  }

  async #destroy(instance: Instance): Promise<void> {
    await this.#runtime?.destroy(instance.id);
    instance.have = undefined;
    instance.isStale = false;
    instance.isGivenUp = false;
    if (instance.want === undefined) this.onStopped.emit(instance.id);
  }

  async #change(instance: Instance, have: Want, want: Want): Promise<void> {
    const runtime = this.#runtime!;
    instance.have = want;
    if (!isEqualMapping(have.spec.mapping, want.spec.mapping)) {
      runtime.remap(instance.id, want.spec.mapping);
    }
    const mode = want.spec.module.processingMode;
    if (!isEqualMode(have.spec.module.processingMode, mode)) runtime.setMode(instance.id, mode);
    if (have.isPaused === want.isPaused) return;
    if (want.isPaused) await runtime.halt(instance.id);
    else runtime.start(instance.id);
  }

  #handleStatus(id: string, status: ProcessingModuleStatus, fault: ModuleFault | undefined): void {
    const instance = this.#instances.get(id);
    // What is under way tells by itself how it went.
    if (instance?.have === undefined || instance.want === undefined) return;
    if (status === ProcessingModuleStatus.DESTROYED) instance.isGivenUp = true;
    if (fault !== undefined) this.onFailed.emit(id, fault.message, fault);
    else if (status === ProcessingModuleStatus.PROCESSING) this.onStarted.emit(id);
  }
}

function keepIfEqual(want: Want, before: Want | undefined): Want {
  if (before === undefined || before.isPaused !== want.isPaused) return want;
  const isEqual =
    !needsRestart(before, want) &&
    isEqualMapping(before.spec.mapping, want.spec.mapping) &&
    isEqualMode(before.spec.module.processingMode, want.spec.module.processingMode);
  return isEqual ? before : want;
}

/** Mappings and modes change while a module runs; the rest of it does not [SE-15]. */
export function needsRestart(have: Want, want: Want): boolean {
  const [before, after] = [have.spec.module, want.spec.module];
  return (
    have.spec.isTrusted !== want.spec.isTrusted ||
    !hasCodeOf(before, after) ||
    JSON.stringify(takenAtStart(before)) !== JSON.stringify(takenAtStart(after))
  );
}

const takenAtStart = ({ inputs, outputs, extension }: ProcessingModule): unknown => [
  inputs,
  outputs,
  extension?.libraries,
  extension?.assets,
  extension?.optionalAssets,
];

function isEqualMapping(one: IOMapping, other: IOMapping): boolean {
  return (
    one === other ||
    isEqualBytes(encode('ubii.sessions.IOMapping', one), encode('ubii.sessions.IOMapping', other))
  );
}

function isEqualMode(one: ProcessingMode | undefined, other: ProcessingMode | undefined): boolean {
  return JSON.stringify(one) === JSON.stringify(other);
}

function isEqualBytes(one: Uint8Array, other: Uint8Array): boolean {
  return one.length === other.length && one.every((byte, i) => byte === other[i]);
}

function isFault(thrown: unknown): thrown is ModuleFault {
  return typeof thrown === 'object' && thrown !== null && 'kind' in thrown && 'message' in thrown;
}
