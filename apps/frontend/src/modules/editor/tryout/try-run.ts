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
import { TryTopics } from './try-topics.ts';

/** `failed`: killed, or it could not be made. */
export type TryStatus = 'off' | 'starting' | 'ready' | 'running' | 'failed';

export interface TryRunEvents {
  onResult(result: SandboxResult): void;
  /** A run threw, or took too long. */
  onFailedRun(): void;
  onEvent(event: ModuleEvent): void;
  onStatus(status: TryStatus): void;
  /** It could not be made, or it was killed. */
  onFault(fault: ModuleFault): void;
}

/** Time that seems to have passed between two steps, milliseconds: one frame of most modules. */
const STEP_MS = 1000 / 30;
/** Id of the module and of its session while it is tried. */
export const TRY_ID = 'try';
const LOCKSTEP = fromJson('ubii.processing.ProcessingMode', { lockstep: {} });

function isFault(thrown: unknown): thrown is ModuleFault {
  return typeof thrown === 'object' && thrown !== null && 'kind' in thrown && 'phase' in thrown;
}

/**
 * One module in this page's sandbox, beside every session: step by step, or as its mode says. The same
 * runtime as on every node; only what goes in and comes out stays here.
 */
export class TryRun {
  readonly topics: TryTopics;
  readonly #events: TryRunEvents;
  readonly #runtime: ModuleRuntime;
  #status: TryStatus = 'off';
  #mode: ProcessingMode | undefined = undefined;
  #isEnding = false;
  /** The end of this instance was told. */
  #wasTold = false;

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
      // What is killed stays so: a person looks at it
      limits: { maxRestarts: 0 },
      // What the one before still has to say is not about this one.
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

  /** Makes a new instance; what was there is destroyed. @returns whether it could be made */
  async open(module: ProcessingModule, mapping: IOMapping): Promise<boolean> {
    this.#move('starting');
    this.#isEnding = true;
    await this.#runtime.destroy(TRY_ID);
    this.#isEnding = false;
    this.#wasTold = false;
    this.#mode = module.processingMode;
    const spec = { ...module, id: TRY_ID, sessionId: TRY_ID, processingMode: LOCKSTEP };
    try {
      // Libraries are the node's: here is none, and code that does without one can be tried
      const extension = spec.extension && { ...spec.extension, libraries: [] };
      await this.#runtime.create({
        module: { ...spec, extension },
        mapping: { ...mapping, processingModuleId: TRY_ID },
        isTrusted: false,
      });
    } catch (thrown) {
      if (!isFault(thrown)) throw thrown;
      // Most failures were told by the status already
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

  /** One run with the inputs as they are. */
  async step(): Promise<void> {
    this.pause();
    const records = this.#runtime.lockstepInputs([TRY_ID]);
    await this.#runtime.runPass({ instanceIds: [TRY_ID], deltaTimeMs: STEP_MS, records });
  }

  /** As its mode says. In lockstep, this page gives the passes. */
  run(): void {
    if (this.#status !== 'ready') return;
    this.#runtime.setMode(TRY_ID, this.#mode);
    this.#move('running');
  }

  get isLockstep(): boolean {
    return this.#mode?.lockstep !== undefined;
  }

  /** One pass of a module that runs in lockstep. */
  async pass(deltaTimeMs: number): Promise<void> {
    const records = this.#runtime.lockstepInputs([TRY_ID]);
    await this.#runtime.runPass({ instanceIds: [TRY_ID], deltaTimeMs, records });
  }

  /** Keeps its state. */
  pause(): void {
    if (this.#status !== 'running') return;
    this.#runtime.setMode(TRY_ID, LOCKSTEP);
    this.#move('ready');
  }

  /** Ends it with what it keeps. */
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
