import type { PatternCompiler } from '@ubii/patterns';
import { createModuleRuntime, type ModuleRuntime, type SandboxFactory } from '@ubii/pm-sandbox';
import { decodeRecord, ModuleEventKind, type IOMapping, type ProcessingModule } from '@ubii/proto';
import { SteppedClock } from './stepped-clock.ts';
import { TryTopics, type TryTopicsOptions } from './try-topics.ts';

/** What a module runs with in recorded time. */
export interface SteppedRunOptions {
  /** With the code to run; inputs and outputs are connected by name. */
  readonly module: ProcessingModule;
  readonly mapping: IOMapping;
  /** Time of day at its beginning, milliseconds since the Unix epoch. */
  readonly startMs: number;
  /** Components that inputs select. @default there are none */
  readonly components?: Pick<TryTopicsOptions, 'topicsOf' | 'deviceOf'>;
  /** The caller closes them. */
  readonly sandboxes: SandboxFactory;
  readonly patterns: PatternCompiler;
  /** @param atMs since the beginning */
  onOutput(topic: string, bytes: Uint8Array, atMs: number): void;
}

const RUN_ID = 'case';
/** Interval of lockstep passes, the default of sessions, milliseconds. [SE-40] */
export const PASS_MS = 1000 / 60;
/** A chain of promises of the runtime is no longer than this. */
const SETTLE_TURNS = 20;

/** Runs one module in this page, in recorded time: its clock stands still until it is moved. */
export class SteppedRun {
  readonly #options: SteppedRunOptions;
  readonly #clock: SteppedClock;
  readonly #topics: TryTopics;
  readonly #runtime: ModuleRuntime;
  readonly #pending = new Set<Promise<unknown>>();
  #fault: string | undefined;

  constructor(options: SteppedRunOptions) {
    const { startMs, components, sandboxes, patterns } = options;
    this.#options = options;
    this.#clock = new SteppedClock(startMs);
    this.#topics = new TryTopics(patterns, {
      ...components,
      onOutput: (topic, bytes) => this.#take(topic, bytes),
    });
    this.#runtime = createModuleRuntime({
      nodeId: 'this-page',
      clock: this.#clock,
      topics: this.#topics,
      patterns,
      sandboxes: this.#waitedFor(sandboxes),
      libraries: [],
      limits: { maxRestarts: 0 },
      onEvent: ({ kind, message }) => {
        if (kind === ModuleEventKind.ERROR || kind === ModuleEventKind.KILLED)
          this.#fault ??= message;
      },
      onStatus: (_id, _status, found) => void (this.#fault ??= found?.message),
    });
  }

  /** The first error of the module. */
  get fault(): string | undefined {
    return this.#fault;
  }

  /** Creates and starts the module. Rejects when it cannot be created. */
  async open(): Promise<void> {
    const { module, mapping } = this.#options;
    const extension = module.extension && { ...module.extension, libraries: [] };
    await this.#runtime.create({
      module: { ...module, id: RUN_ID, sessionId: RUN_ID, extension },
      mapping: { ...mapping, processingModuleId: RUN_ID },
      isTrusted: false,
    });
    this.#runtime.start(RUN_ID);
  }

  put(topic: string, bytes: Uint8Array, publisherId: string): void {
    this.#topics.put(topic, bytes, publisherId);
  }

  /** Begins the passes of a module in lockstep. */
  beginPasses(): void {
    if (!this.#options.module.processingMode?.lockstep) return;
    this.#clock.every(PASS_MS, () => {
      const records = this.#runtime.lockstepInputs([RUN_ID]);
      const pass = { instanceIds: [RUN_ID], deltaTimeMs: PASS_MS, records };
      // Passes do not publish; their records are complete.
      const taken = this.#runtime.runPass(pass).then((reply) => {
        for (const bytes of reply.records) this.#take(decodeRecord(bytes).topic, bytes);
      });
      void this.#track(taken);
    });
  }

  /** Waits until no run of the module is under way. */
  readonly rest = async (): Promise<void> => {
    for (;;) {
      for (let turn = 0; turn < SETTLE_TURNS; turn++) await Promise.resolve();
      if (this.#pending.size === 0) return;
      await Promise.allSettled(this.#pending);
    }
  };

  /** @param elapsedMs since the beginning */
  moveTo(elapsedMs: number): Promise<void> {
    return this.#clock.moveTo(elapsedMs, this.rest);
  }

  close(): Promise<void> {
    return this.#runtime.close();
  }

  #take(topic: string, bytes: Uint8Array): void {
    this.#options.onOutput(topic, bytes, this.#clock.monotonicMs());
  }

  /** Wraps sandboxes, so that their runs are waited for. */
  #waitedFor(sandboxes: SandboxFactory): SandboxFactory {
    return {
      open: (request, events) => {
        const sandbox = sandboxes.open(request, events);
        return {
          create: () => sandbox.create(),
          halt: () => sandbox.halt(),
          destroy: () => sandbox.destroy(),
          terminate: () => sandbox.terminate(),
          run: (call) => this.#track(sandbox.run(call)),
        };
      },
      check: (source) => sandboxes.check(source),
      close: () => Promise.resolve(),
    };
  }

  #track<T>(run: Promise<T>): Promise<T> {
    const done = run.finally(() => this.#pending.delete(run));
    this.#pending.add(run);
    return done;
  }
}
