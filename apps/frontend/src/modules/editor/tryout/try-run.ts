import type { PatternCompiler } from '@ubii/patterns';
import {
  createModuleRuntime,
  type ModuleFault,
  type ModuleRuntime,
  type SandboxFactory,
  type SandboxResult,
} from '@ubii/pm-sandbox';
import {
  fromJson,
  type IOMapping,
  type ModuleEvent,
  type ProcessingMode,
  type ProcessingModule,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { tapSandboxes } from './tap-sandboxes.ts';
import { TryTopics } from '../../cases/try-topics.ts';

/** `failed`: killed, or it could not be created. */
export type TryStatus = 'off' | 'starting' | 'ready' | 'running' | 'failed';

export interface TryRunEvents {
  onResult(result: SandboxResult): void;
  /** Called when a run threw or timed out. */
  onFailedRun(): void;
  onEvent(event: ModuleEvent): void;
  onStatus(status: TryStatus): void;
  /** Called when the instance could not be created, or was killed. */
  onFault(fault: ModuleFault): void;
}

/** Simulated time between two single steps, milliseconds. */
const STEP_MS = 1000 / 30;
/** Id of the module and of its session in the try-out. */
export const TRY_ID = 'try';
const LOCKSTEP = fromJson('ubii.processing.ProcessingMode', { lockstep: {} });

function isFault(thrown: unknown): thrown is ModuleFault {
  return typeof thrown === 'object' && thrown !== null && 'kind' in thrown && 'phase' in thrown;
}

/**
 * Runs one module in this page's sandbox, without a session: step by step, or in its processing mode. Uses the same
 * runtime as all nodes; inputs and outputs stay in this page.
 */
export class TryRun {
  readonly topics: TryTopics;
  readonly #events: TryRunEvents;
  readonly #runtime: ModuleRuntime;
  #status: TryStatus = 'off';
  #mode: ProcessingMode | undefined = undefined;
  #isEnding = false;
  /** True after the end of this instance was reported. */
  #wasTold = false;
  #opening: Promise<boolean> = Promise.resolve(false);
  #lastStep: Promise<void> = Promise.resolve();

  constructor(
    sandboxes: SandboxFactory,
    patterns: PatternCompiler,
    clock: Clock,
    events: TryRunEvents,
  ) {
    this.topics = new TryTopics(patterns);
    this.#events = events;
    this.#runtime = createModuleRuntime({
      nodeId: 'this-page',
      clock,
      topics: this.topics,
      patterns,
      sandboxes: tapSandboxes(
        sandboxes,
        (result) => events.onResult(result),
        () => events.onFailedRun(),
      ),
      libraries: [],
      // Do not restart killed modules, so that the user can examine the problem.
      limits: { maxRestarts: 0 },
      // Ignore events of the previous instance.
      onEvent: (event) => this.#isEnding || events.onEvent(event),
      onStatus: (_id, _status, fault) => {
        if (!fault || this.#wasTold) return;
        this.#wasTold = true;
        this.#move('failed');
        events.onFault(fault);
      },
    });
  }

  get status(): TryStatus {
    return this.#status;
  }

  /** Creates a new instance and destroys the previous one. @returns whether it could be created */
  open(module: ProcessingModule, mapping: IOMapping): Promise<boolean> {
    this.#opening = this.#create(module, mapping);
    return this.#opening;
  }

  async #create(module: ProcessingModule, mapping: IOMapping): Promise<boolean> {
    this.#move('starting');
    this.#isEnding = true;
    await this.#runtime.destroy(TRY_ID);
    this.#isEnding = false;
    this.#wasTold = false;
    this.#mode = module.processingMode;
    const spec = { ...module, id: TRY_ID, sessionId: TRY_ID, processingMode: LOCKSTEP };
    try {
      // Libraries are provided by nodes: here, code that works without them can be tried.
      const extension = spec.extension && { ...spec.extension, libraries: [] };
      await this.#runtime.create({
        module: { ...spec, extension },
        mapping: { ...mapping, processingModuleId: TRY_ID },
        isTrusted: false,
      });
    } catch (thrown) {
      if (!isFault(thrown)) throw thrown;
      // Most failures were reported by the status already.
      const isTold = this.#wasTold;
      this.#move('failed');
      if (!isTold) this.#events.onFault(thrown);
      return false;
    }
    this.#runtime.start(TRY_ID);
    this.#move('ready');
    return true;
  }

  remap(mapping: IOMapping): void {
    this.#runtime.remap(TRY_ID, mapping);
  }

  /** Runs once with the current inputs, when the instance is there and the steps before have ended. */
  step(): Promise<void> {
    this.#lastStep = this.#lastStep.catch(() => undefined).then(() => this.#step());
    return this.#lastStep;
  }

  async #step(): Promise<void> {
    if (!(await this.#opening)) return;
    this.pause();
    const records = this.#runtime.lockstepInputs([TRY_ID]);
    await this.#runtime.runPass({ instanceIds: [TRY_ID], deltaTimeMs: STEP_MS, records });
  }

  /** Runs in the processing mode. This page triggers the passes for lockstep. */
  run(): void {
    if (this.#status !== 'ready') return;
    this.#runtime.setMode(TRY_ID, this.#mode);
    this.#move('running');
  }

  get isLockstep(): boolean {
    return this.#mode?.lockstep !== undefined;
  }

  /** Runs one pass of a module in lockstep. */
  async pass(deltaTimeMs: number): Promise<void> {
    const records = this.#runtime.lockstepInputs([TRY_ID]);
    await this.#runtime.runPass({ instanceIds: [TRY_ID], deltaTimeMs, records });
  }

  /** Pauses and keeps the state. */
  pause(): void {
    if (this.#status !== 'running') return;
    this.#runtime.setMode(TRY_ID, LOCKSTEP);
    this.#move('ready');
  }

  /** Ends the run and releases its resources. */
  async close(): Promise<void> {
    await this.#runtime.close();
    this.#move('off');
  }

  #move(status: TryStatus): void {
    if (status === this.#status) return;
    this.#status = status;
    this.#events.onStatus(status);
  }
}
