import { REPLAYS_TOPIC, type Replay } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import type { MasterPublisher } from '../info/master-publisher.ts';

/** Time between two lists, milliseconds. [RP-7] */
const INTERVAL_MS = 200;

/** Publishes the list of replays when it changes, at most so often. */
export class ReplayNews {
  readonly #publisher: MasterPublisher;
  readonly #clock: Clock;
  readonly #list: () => readonly Replay[];
  #toldMs = Number.NEGATIVE_INFINITY;
  #cancel: Cancel | undefined = undefined;

  constructor(publisher: MasterPublisher, clock: Clock, list: () => readonly Replay[]) {
    this.#publisher = publisher;
    this.#clock = clock;
    this.#list = list;
  }

  /** Something changed. */
  announce(): void {
    if (this.#cancel !== undefined) return;
    const waitMs = this.#toldMs + INTERVAL_MS - this.#clock.monotonicMs();
    if (waitMs <= 0) return this.#publish();
    this.#cancel = this.#clock.after(waitMs, () => {
      this.#cancel = undefined;
      this.#publish();
    });
  }

  /** Ends the timer. */
  close(): void {
    this.#cancel?.();
  }

  #publish(): void {
    this.#toldMs = this.#clock.monotonicMs();
    this.#publisher.publish(REPLAYS_TOPIC, { replayList: { elements: this.#list() } });
  }
}
