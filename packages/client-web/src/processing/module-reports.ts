import { ProcessingModuleStatus, ServiceError } from '@ubii/proto';
import type { Init, ModuleEvent, ModuleStatistics, ProcessingModule } from '@ubii/proto';
import { encodeNodeMessageFrame } from '@ubii/proto/wire';
import type { WantedInstance } from '@ubii/pm-sandbox';
import type { UbiiClient } from '../core/client/ubii-client.ts';

/** Dependencies of the reports on a client. */
export type ReportClient = Pick<UbiiClient, 'call' | 'sendNodeMessage' | 'state'>;

/** Callbacks of the reports. */
export interface ModuleReportsOptions {
  /** The master knows nothing of a module that was reported. */
  readonly handleUnknown: () => void;
}

/**
 * Tells the master what became of the modules of this node: one request at a time, so that none
 * overtakes another, and everything of one turn in one request. [PM-62]
 */
export class ModuleReports {
  readonly #client: ReportClient;
  readonly #options: ModuleReportsOptions;
  readonly #started = new Map<string, Init<ProcessingModule>>();
  readonly #ended = new Map<string, Init<ProcessingModule>>();
  #events: ModuleEvent[] = [];
  #sending: Promise<void> | undefined;

  constructor(client: ReportClient, options: ModuleReportsOptions) {
    this.#client = client;
    this.#options = options;
  }

  started({ spec, isPaused }: WantedInstance): void {
    const status = isPaused ? ProcessingModuleStatus.HALTED : ProcessingModuleStatus.PROCESSING;
    const { id, name, nodeId, sessionId } = spec.module;
    this.#started.set(id, { id, name, nodeId, sessionId, status });
    this.#tell();
  }

  ended({ spec }: WantedInstance): void {
    const { id, name, nodeId, sessionId } = spec.module;
    // An instance that ended before its start was reported needs both: the session waits for either.
    this.#ended.set(id, { id, name, nodeId, sessionId, status: ProcessingModuleStatus.DESTROYED });
    this.#started.delete(id);
    this.#tell();
  }

  /** [PM-80] */
  statistics(statistics: readonly ModuleStatistics[]): void {
    this.#client.sendNodeMessage(
      encodeNodeMessageFrame({ moduleReports: { statistics: [...statistics] } }),
    );
  }

  /** Those of one turn travel together. [PM-81] */
  event(event: ModuleEvent): void {
    if (this.#events.push(event) > 1) return;
    void Promise.resolve().then(() => {
      const events = this.#events;
      this.#events = [];
      this.#client.sendNodeMessage(encodeNodeMessageFrame({ moduleReports: { events } }));
    });
  }

  /** Sends reports that could not be sent before. */
  resume(): void {
    this.#tell();
  }

  /** Resolves when all reports are sent, or cannot be. */
  async settled(): Promise<void> {
    while (this.#sending !== undefined) await this.#sending;
  }

  #tell(): void {
    this.#sending ??= this.#sendAll().finally(() => {
      this.#sending = undefined;
    });
  }

  async #sendAll(): Promise<void> {
    await Promise.resolve(); // everything of one turn is one request
    while (this.#client.state.status === 'connected') {
      // Report ended modules first: they may have started again since.
      const isEnd = this.#ended.size > 0;
      const waiting = isEnd ? this.#ended : this.#started;
      if (waiting.size === 0) return;
      const sent = new Map(waiting);
      waiting.clear();
      try {
        await this.#client.call(
          isEnd ? 'processingModuleRuntimeRemove' : 'processingModuleRuntimeAdd',
          { elements: [...sent.values()] },
        );
      } catch (error) {
        if (error instanceof ServiceError) {
          if (!isEnd) this.#options.handleUnknown();
          continue;
        }
        // The report was lost. Later reports are newer, and an end cancels a start.
        for (const [id, module] of sent) {
          if (!waiting.has(id) && (isEnd || !this.#ended.has(id))) waiting.set(id, module);
        }
        return;
      }
    }
  }
}
