import type { PatternSource } from '@ubii/patterns';
import { ProcessingModuleStatus } from '@ubii/proto';
import type { ModuleStatistics, ProcessingModule } from '@ubii/proto';
import { mappingNeedsPatterns } from '@ubii/pm-sandbox';
import type { InstanceSpec, ModuleFault, ModuleRuntime } from '@ubii/pm-sandbox';
import type { ModuleCatalog } from './module-catalog.ts';
import type { NodeInstance } from './node-instance.ts';
import type { AssignedModule } from './session-modules.ts';

/** Dependencies and callbacks of a keeper. */
export interface InstanceKeeperOptions {
  readonly runtime: ModuleRuntime;
  /** Loaded before an instance whose muxers need it. */
  readonly patterns: PatternSource;
  readonly catalog: () => ModuleCatalog;
  /** It runs, or is ready to where its session is paused. */
  readonly handleStarted: (assigned: AssignedModule) => void;
  /** It has ended, or could never be made. */
  readonly handleEnded: (assigned: AssignedModule) => void;
  readonly handleFailed: (assigned: AssignedModule, fault: ModuleFault) => void;
  /** Called when the visible state of the instance changed. */
  readonly handleChange: () => void;
}

interface Wanted {
  readonly assigned: AssignedModule;
  readonly spec: InstanceSpec;
  /** With another one the instance has to be made again. */
  readonly codeKey: string;
  readonly mappingKey: string;
  readonly modeKey: string;
  /** Why it cannot be made, if that is known beforehand. */
  readonly fault: ModuleFault | undefined;
}

/** The instance, or the failure of one that could not be created. */
interface Present {
  readonly as: Wanted;
  readonly isMade: boolean;
}

/**
 * Brings one instance in line with what its session wants, one step after the other: every step may
 * take its time, and what is wanted may change meanwhile. [PM-62]
 */
export class InstanceKeeper {
  readonly id: string;
  readonly #options: InstanceKeeperOptions;
  #wanted: Wanted | undefined;
  #present: Present | undefined;
  /** It was not wanted at some moment since it was made: its session was stopped. */
  #mustEnd = false;
  #isProcessing = false;
  #isReported = false;
  #running: Promise<void> | undefined;
  #shown: Omit<NodeInstance, 'id'>;

  constructor(id: string, options: InstanceKeeperOptions) {
    this.id = id;
    this.#options = options;
    this.#shown = {
      moduleName: '',
      sessionId: '',
      sessionName: '',
      status: ProcessingModuleStatus.INITIALIZED,
      fault: undefined,
      statistics: undefined,
    };
  }

  /** Visible state of the instance. */
  get shown(): NodeInstance {
    return { id: this.id, ...this.#shown };
  }

  get sessionId(): string {
    return this.#shown.sessionId;
  }

  /** Whether there is nothing of it and nothing to come. */
  get isGone(): boolean {
    return this.#wanted === undefined && this.#present === undefined && this.#running === undefined;
  }

  /** The last report as started that is still valid. */
  get reported(): AssignedModule | undefined {
    return this.#isReported && !this.#mustEnd ? this.#wanted?.assigned : undefined;
  }

  want(assigned: AssignedModule): void {
    this.#wanted = wantedOf(assigned, this.#options.catalog());
    const { sessionId, sessionName, module } = assigned;
    this.#show({ moduleName: module.name, sessionId, sessionName });
    this.#run();
  }

  /** Its session was stopped, or it left its session, or its node stops. */
  unwant(): void {
    this.#wanted = undefined;
    this.#mustEnd = this.#present !== undefined || this.#running !== undefined;
    this.#run();
  }

  /** Resolves when there is nothing left to be done. */
  async settled(): Promise<void> {
    while (this.#running !== undefined) await this.#running;
  }

  /** The runtime says how it is. */
  handleStatus(status: ProcessingModuleStatus, fault: ModuleFault | undefined): void {
    this.#show({ status, fault });
  }

  handleStatistics(statistics: ModuleStatistics): void {
    this.#show({ statistics });
  }

  #run(): void {
    this.#running ??= this.#runSteps().finally(() => {
      this.#running = undefined;
      this.#options.handleChange();
    });
  }

  async #runSteps(): Promise<void> {
    await Promise.resolve(); // everything that is said in one turn counts as one
    for (;;) {
      const present = this.#present;
      const wanted = this.#wanted;
      if (present === undefined) {
        this.#mustEnd = false;
        if (wanted === undefined) return;
        await this.#make(wanted);
      } else if (this.#mustEnd || wanted?.codeKey !== present.as.codeKey) {
        await this.#end(present);
      } else if (!present.isMade) {
        return; // it stays failed until its session is started again
      } else {
        await this.#adjust(present, wanted);
        if (this.#wanted === wanted && !this.#mustEnd) return;
      }
    }
  }

  async #make(wanted: Wanted): Promise<void> {
    this.#show({
      status: ProcessingModuleStatus.INITIALIZED,
      fault: undefined,
      statistics: undefined,
    });
    try {
      if (wanted.fault !== undefined) throw wanted.fault;
      await this.#loadPatterns(wanted.spec);
      await this.#options.runtime.create(wanted.spec);
      this.#present = { as: wanted, isMade: true };
    } catch (error) {
      this.#fail(wanted, faultOf(error));
    }
  }

  /** Brings an instance that is there in line, without a restart. */
  async #adjust({ as }: Present, wanted: Wanted): Promise<void> {
    const { runtime } = this.#options;
    const { mapping, module } = wanted.spec;
    this.#present = { as: wanted, isMade: true };
    try {
      if (wanted.mappingKey !== as.mappingKey) {
        await this.#loadPatterns(wanted.spec);
        runtime.remap(this.id, mapping);
      }
      if (wanted.modeKey !== as.modeKey) runtime.setMode(this.id, module.processingMode);
      if (wanted.assigned.isPaused && this.#isProcessing) {
        this.#isProcessing = false;
        await runtime.halt(this.id);
      } else if (!wanted.assigned.isPaused && !this.#isProcessing) {
        this.#isProcessing = true;
        runtime.start(this.id);
      }
    } catch (error) {
      this.#fail(wanted, faultOf(error));
      return;
    }
    if (this.#isReported) return;
    this.#isReported = true;
    this.#options.handleStarted(wanted.assigned);
  }

  /** [TD-64] */
  async #loadPatterns({ mapping }: InstanceSpec): Promise<void> {
    const { patterns } = this.#options;
    if (patterns.compiler !== undefined || !mappingNeedsPatterns(mapping)) return;
    await patterns.load();
  }

  async #end({ as }: Present): Promise<void> {
    const { runtime } = this.#options;
    try {
      if (runtime.has(this.id)) {
        await runtime.halt(this.id);
        await runtime.destroy(this.id);
      }
    } catch {
      // Faults of onHalted and onDestroyed are reported by the runtime; it is gone anyway.
    }
    this.#present = undefined;
    this.#isProcessing = false;
    this.#isReported = false;
    this.#show({ status: ProcessingModuleStatus.DESTROYED });
    this.#options.handleEnded(as.assigned);
  }

  #fail(wanted: Wanted, fault: ModuleFault): void {
    this.#present = { as: wanted, isMade: false };
    this.#isProcessing = false;
    this.#show({ status: ProcessingModuleStatus.DESTROYED, fault });
    this.#options.handleFailed(wanted.assigned, fault);
  }

  #show(change: Partial<Omit<NodeInstance, 'id'>>): void {
    this.#shown = { ...this.#shown, ...change };
    this.#options.handleChange();
  }
}

function wantedOf(assigned: AssignedModule, catalog: ModuleCatalog): Wanted {
  const { mapping } = assigned;
  const resolved = catalog.resolve(assigned.module);
  const fault = 'fault' in resolved ? resolved.fault : undefined;
  const { module, isTrusted } =
    'fault' in resolved ? { module: assigned.module, isTrusted: false } : resolved;
  return {
    assigned,
    spec: { module, mapping, isTrusted },
    codeKey: codeKeyOf(module, isTrusted, fault),
    mappingKey: JSON.stringify(mapping),
    modeKey: JSON.stringify(module.processingMode),
    fault,
  };
}

/** Returns the parts of a module that cannot change during the life of its instance. */
function codeKeyOf(
  module: ProcessingModule,
  isTrusted: boolean,
  fault: ModuleFault | undefined,
): string {
  return JSON.stringify([
    module.name,
    module.sessionId,
    module.language,
    module.onCreatedStringified,
    module.onProcessingStringified,
    module.onHaltedStringified,
    module.onDestroyedStringified,
    module.inputs,
    module.outputs,
    module.extension?.libraries,
    module.extension?.assets,
    module.extension?.optionalAssets,
    isTrusted,
    fault,
  ]);
}

/** The runtime rejects with faults; anything else is a fault of its own. */
function faultOf(error: unknown): ModuleFault {
  if (typeof error === 'object' && error !== null && 'kind' in error && 'message' in error) {
    return error as ModuleFault;
  }
  const message = error instanceof Error ? error.message : String(error);
  return { kind: 'crashed', phase: '', message };
}
