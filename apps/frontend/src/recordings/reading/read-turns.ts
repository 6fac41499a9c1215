/** What is read first: where the playhead goes, then pictures in view, then tiles in view, then all of the recording. */
export type ReadUrgency = 'seek' | 'frame' | 'tile' | 'survey';

const ORDER: readonly ReadUrgency[] = ['seek', 'frame', 'tile', 'survey'];
/** Without a pause no longer than this: commands arrive in between, milliseconds. */
const TURN_MS = 8;
/** What is less urgent goes on for a turn after waiting this long, milliseconds. */
const MAX_WAIT_MS = 250;

/** What time it is, and how others get their turn. */
export interface TurnClock {
  nowMs(): number;
  /** Lets events and other reads go first. */
  pause(): Promise<void>;
  /** Resolves after a time. */
  wait(ms: number): Promise<void>;
}

/** One read that takes long: it pauses, and waits for what is more urgent. */
export interface ReadTurn {
  /** Asked for between records; undefined while the turn lasts, so that most records cost no promise. */
  next(): Promise<void> | undefined;
}

/** Reads of one recording, the more urgent ones first. */
export class ReadTurns {
  readonly #clock: TurnClock;
  readonly #running = new Map<ReadUrgency, number>();
  readonly #waiting = new Set<() => void>();

  constructor(clock: TurnClock) {
    this.#clock = clock;
  }

  nowMs(): number {
    return this.#clock.nowMs();
  }

  /** Runs a read, after more urgent ones that are under way. Less urgent ones wait until it is done. */
  async run<T>(urgency: ReadUrgency, read: (turn: ReadTurn) => Promise<T>): Promise<T> {
    this.#count(urgency, 1);
    try {
      if (this.#hasMoreUrgent(urgency)) await this.#giveWay(urgency);
      return await read(this.#turnOf(urgency));
    } finally {
      this.#count(urgency, -1);
      for (const resume of this.#waiting) resume();
    }
  }

  #turnOf(urgency: ReadUrgency): ReadTurn {
    let startedMs = this.#clock.nowMs();
    return {
      next: () => {
        if (this.#clock.nowMs() - startedMs < TURN_MS) return undefined;
        return this.#giveWay(urgency).then(() => void (startedMs = this.#clock.nowMs()));
      },
    };
  }

  async #giveWay(urgency: ReadUrgency): Promise<void> {
    await this.#clock.pause();
    const untilMs = this.#clock.nowMs() + MAX_WAIT_MS;
    while (this.#hasMoreUrgent(urgency)) {
      const leftMs = untilMs - this.#clock.nowMs();
      if (leftMs <= 0) return;
      await this.#nextDone(leftMs);
    }
  }

  /** Resolves when a read is done, or after a time. */
  async #nextDone(mostMs: number): Promise<void> {
    const { promise, resolve } = withResolve();
    this.#waiting.add(resolve);
    await Promise.race([promise, this.#clock.wait(mostMs)]);
    this.#waiting.delete(resolve);
  }

  #hasMoreUrgent(urgency: ReadUrgency): boolean {
    return ORDER.slice(0, ORDER.indexOf(urgency)).some((one) => (this.#running.get(one) ?? 0) > 0);
  }

  #count(urgency: ReadUrgency, by: 1 | -1): void {
    this.#running.set(urgency, (this.#running.get(urgency) ?? 0) + by);
  }
}

function withResolve(): { readonly promise: Promise<void>; readonly resolve: () => void } {
  let resolve = (): void => undefined;
  const promise = new Promise<void>((fulfil) => (resolve = fulfil));
  return { promise, resolve };
}
