import type { Clock } from '@ubii/timing';
import type { ClientRegistry } from '../clients/client-registry.ts';
import { clockEvent, type Recorder } from '@ubii/recording/recorder';
import type { RecordCollector } from './record-collector.ts';

/** What clocks are recorded with. */
export interface RecordedClocksContext {
  readonly clock: Clock;
  readonly clients: ClientRegistry;
  readonly recorder: Recorder;
  readonly collector: RecordCollector;
}

/** Records clocks of clients when they have changed. [RC-14] */
export class RecordedClocks {
  readonly #context: RecordedClocksContext;
  /** When they were looked at last, monotonic milliseconds. */
  #lookedMs = 0;

  constructor(context: RecordedClocksContext) {
    this.#context = context;
  }

  look(): void {
    const { clients, clock, recorder, collector } = this.#context;
    const sinceMs = this.#lookedMs;
    this.#lookedMs = clock.monotonicMs();
    for (const client of clients.values()) {
      if (client.clock === undefined || client.clock.toldMs < sinceMs) continue;
      recorder.addEvent(clockEvent(client.id, client.clock, clock.nowMs()), collector.targets);
    }
  }
}
