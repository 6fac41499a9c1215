import type { PatternCompiler } from '@ubii/patterns';
import type { ModuleEvent, ProcessingModuleStatus } from '@ubii/proto';
import { EndOfTurn, type Clock } from '@ubii/timing';
import { DEFAULT_RUNTIME_LIMITS, type RuntimeLimits } from '../limits.ts';
import type { AssetStore } from '../assets/asset-store.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxFactory } from '../ports/sandbox.ts';
import type { EncodedRecord, TopicPort } from '../ports/topic-port.ts';
import { RecordCompletion } from './binding/record-completion.ts';
import { SessionPatterns } from './binding/session-patterns.ts';
import { ModuleInstance } from './module-instance.ts';
import type { InstanceSpec, ModuleRuntime, PassReply, PassRequest } from './module-runtime.ts';
import type { RuntimeContext } from './runtime-context.ts';

/** Dependencies of a runtime. */
export interface ModuleRuntimeOptions {
  /** Id of the client or master it is: the client id of all that its modules put out. */
  readonly nodeId: string;
  /** Its time of day is that of the master [PM-15]. */
  readonly clock: Clock;
  readonly topics: TopicPort;
  readonly patterns: PatternCompiler;
  /** Stays open when the runtime is closed. */
  readonly sandboxes: SandboxFactory;
  /** @default DEFAULT_RUNTIME_LIMITS */
  readonly limits?: Partial<RuntimeLimits> | undefined;
  /** Names of the libraries the sandboxes offer. @default none */
  readonly libraries?: readonly string[] | undefined;
  /** Loads the asset sets of trusted modules. @default none: such modules cannot run */
  readonly assets?: AssetStore | undefined;
  /**
   * `own`: lockstep modules subscribe to their inputs, so that `lockstepInputs` knows them. `given`: the
   * snapshots come from elsewhere, and nothing is subscribed to that they bring. @default 'own'
   */
  readonly lockstepInputs?: 'own' | 'given' | undefined;
  /** [PM-81] */
  onEvent(event: ModuleEvent): void;
  /**
   * The status of an instance changed: INITIALIZED with a fault when it was killed and waits to be
   * created again, CREATED, PROCESSING, HALTED, DESTROYED; the last with a fault when it has failed
   * permanently, and is there until `destroy`.
   */
  onStatus(instanceId: string, status: ProcessingModuleStatus, fault?: ModuleFault): void;
}

/** Makes the runtime of one node. */
export function createModuleRuntime(options: ModuleRuntimeOptions): ModuleRuntime {
  return new NodeModuleRuntime(options);
}

class NodeModuleRuntime implements ModuleRuntime {
  readonly #context: RuntimeContext;
  readonly #instances = new Map<string, ModuleInstance>();

  constructor(options: ModuleRuntimeOptions) {
    const { nodeId, clock, topics, patterns, sandboxes } = options;
    const limits = { ...DEFAULT_RUNTIME_LIMITS, ...options.limits };
    this.#context = {
      nodeId,
      clock,
      topics,
      patterns: new SessionPatterns(patterns, clock, limits),
      sandboxes,
      limits,
      libraries: options.libraries ?? [],
      assets: options.assets,
      lockstepInputs: options.lockstepInputs ?? 'own',
      endOfTurn: new EndOfTurn(clock),
      completion: new RecordCompletion(nodeId),
      onEvent: (event) => options.onEvent(event),
      onStatus: (instanceId, status, fault) => options.onStatus(instanceId, status, fault),
    };
  }

  get instanceCount(): number {
    return this.#instances.size;
  }

  async create(spec: InstanceSpec): Promise<void> {
    const { id } = spec.module;
    if (this.#instances.has(id)) throw new Error(`the instance ${id} exists already`);
    const instance = new ModuleInstance(spec, this.#context);
    this.#instances.set(id, instance);
    const fault = await instance.create();
    if (fault === undefined) return;
    if (this.#instances.get(id) === instance) this.#instances.delete(id);
    await instance.destroy();
    throw fault;
  }

  start(instanceId: string): void {
    this.#instances.get(instanceId)?.start();
  }

  async halt(instanceId: string): Promise<void> {
    await this.#instances.get(instanceId)?.halt();
  }

  async destroy(instanceId: string): Promise<void> {
    const instance = this.#instances.get(instanceId);
    if (instance === undefined) return;
    await instance.destroy();
    if (this.#instances.get(instanceId) === instance) this.#instances.delete(instanceId);
  }

  remap(instanceId: string, mapping: InstanceSpec['mapping']): void {
    this.#instances.get(instanceId)?.remap(mapping);
  }

  setMode(instanceId: string, mode: InstanceSpec['module']['processingMode']): void {
    this.#instances.get(instanceId)?.setMode(mode);
  }

  lockstepInputs(instanceIds: readonly string[]): EncodedRecord[] {
    const records = new Map<string, EncodedRecord>();
    for (const instanceId of instanceIds) {
      for (const record of this.#instances.get(instanceId)?.records() ?? []) {
        records.set(record.topic, record);
      }
    }
    return [...records.values()];
  }

  async runPass(pass: PassRequest): Promise<PassReply> {
    const snapshot = new Map(pass.records.map((record) => [record.topic, record]));
    // All start before any ends: none sees what another one of the pass puts out.
    const runs = pass.instanceIds.map(
      (instanceId) =>
        this.#instances.get(instanceId)?.runOnce(snapshot, pass.deltaTimeMs) ??
        Promise.resolve(undefined),
    );
    const outputs = await Promise.all(runs);
    const instanceIds = pass.instanceIds.filter((_id, index) => outputs[index] !== undefined);
    const records = outputs.flatMap((records) => records?.map(({ bytes }) => bytes) ?? []);
    return { instanceIds, records };
  }

  has(instanceId: string): boolean {
    return this.#instances.has(instanceId);
  }

  statistics() {
    return [...this.#instances.values()].map((instance) => instance.statistics());
  }

  async close(): Promise<void> {
    await Promise.all([...this.#instances.keys()].map((id) => this.destroy(id)));
  }
}
