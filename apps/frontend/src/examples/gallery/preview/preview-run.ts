import type { PatternCompiler } from '@ubii/patterns';
import { createModuleRuntime, type ModuleRuntime, type SandboxFactory } from '@ubii/pm-sandbox';
import {
  decodeRecord,
  type ProcessingModule,
  type RecordInit,
  type Session,
  type TopicRecord,
} from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { PageTopics } from './page-topics.ts';

/** Dependencies of a preview run. */
export interface PreviewWorld {
  readonly sandboxes: SandboxFactory;
  readonly patterns: PatternCompiler;
  readonly clock: Clock;
}

/** Default interval of lockstep passes. [SE-40] */
const PASS_MS = 1000 / 60;

/**
 * A session that runs only in this page: modules of the library, in the same runtime as on nodes, on
 * topics of the page. Its records do not reach the master.
 */
export class PreviewRun {
  readonly #topics: PageTopics;
  readonly #runtime: ModuleRuntime;
  readonly #clock: Clock;
  readonly #session: Session;
  readonly #library: readonly ProcessingModule[];
  #endPasses: () => void = () => undefined;
  #passedMs = 0;
  #isPassing = false;
  #isClosed = false;

  /**
   * @param session complete, with an id for each module
   * @param onRecord called with every record of the session, including its inputs
   */
  constructor(
    session: Session,
    library: readonly ProcessingModule[],
    { sandboxes, patterns, clock }: PreviewWorld,
    onRecord: (record: TopicRecord) => void,
  ) {
    this.#session = session;
    this.#library = library;
    this.#clock = clock;
    this.#topics = new PageTopics(patterns, onRecord);
    this.#runtime = createModuleRuntime({
      nodeId: 'this-page',
      clock,
      topics: this.#topics,
      patterns,
      sandboxes,
      limits: { maxRestarts: 0 },
      onEvent: () => undefined,
      onStatus: () => undefined,
    });
  }

  /** Creates and starts all modules. */
  async start(): Promise<void> {
    const lockstep: string[] = [];
    for (const { id, name, processingMode } of this.#session.processingModules) {
      const module = this.#library.find((candidate) => candidate.name === name);
      const mapping = this.#session.ioMappings.find((one) => one.processingModuleId === id);
      if (module === undefined || mapping === undefined) continue;
      const mode = processingMode ?? module.processingMode;
      if (mode?.lockstep) lockstep.push(id);
      await this.#runtime.create({
        module: { ...module, id, sessionId: 'preview', processingMode: mode },
        mapping,
        // Part of this program.
        isTrusted: true,
      });
      if (this.#isClosed) return this.#runtime.close();
    }
    for (const { id } of this.#session.processingModules) this.#runtime.start(id);
    if (lockstep.length > 0) {
      this.#passedMs = this.#clock.monotonicMs();
      this.#endPasses = this.#clock.every(PASS_MS, () => void this.#pass(lockstep));
    }
  }

  /** Publishes an input of the page. */
  put(record: RecordInit): void {
    if (!this.#isClosed) this.#topics.put(record);
  }

  async close(): Promise<void> {
    this.#isClosed = true;
    this.#endPasses();
    await this.#runtime.close();
  }

  async #pass(instanceIds: readonly string[]): Promise<void> {
    if (this.#isPassing) return;
    // Measure the time, because timers of a busy page are late.
    const nowMs = this.#clock.monotonicMs();
    const deltaTimeMs = nowMs - this.#passedMs;
    this.#passedMs = nowMs;
    this.#isPassing = true;
    const records = this.#runtime.lockstepInputs(instanceIds);
    const reply = await this.#runtime.runPass({ instanceIds, deltaTimeMs, records });
    this.#isPassing = false;
    if (this.#isClosed) return;
    for (const bytes of reply.records) this.#topics.publish(decodeRecord(bytes).topic, bytes);
  }
}
