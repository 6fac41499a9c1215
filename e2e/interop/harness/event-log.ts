/** Waiting longer than this for an event means it will not come. */
const EVENT_TIMEOUT_MS = 30_000;

interface Waiter<E> {
  readonly isMet: (events: readonly E[]) => E | undefined;
  readonly resolve: (event: E) => void;
  readonly reject: (error: Error) => void;
}

/** Everything a client reported, in order, and waiting for what is still to come. */
export class EventLog<E> {
  readonly #events: E[] = [];
  readonly #waiters = new Set<Waiter<E>>();
  #ended: Error | undefined;

  get all(): readonly E[] {
    return this.#events;
  }

  add(event: E): void {
    this.#events.push(event);
    for (const waiter of this.#waiters) {
      const met = waiter.isMet(this.#events);
      if (met !== undefined) waiter.resolve(met);
    }
  }

  /** No more events will come: whoever waits learns why. */
  end(reason: Error): void {
    this.#ended = reason;
    for (const waiter of this.#waiters) waiter.reject(reason);
  }

  /** The `count`-th event that fits, now or later. @param what names it, for the message when it does not come */
  async waitFor<F extends E>(
    what: string,
    fits: (event: E) => event is F,
    count?: number,
  ): Promise<F>;
  async waitFor(what: string, fits: (event: E) => boolean, count?: number): Promise<E>;
  async waitFor(what: string, fits: (event: E) => boolean, count = 1): Promise<E> {
    const isMet = (events: readonly E[]): E | undefined => events.filter(fits)[count - 1];
    const already = isMet(this.#events);
    if (already !== undefined) return already;
    if (this.#ended) throw this.#ended;
    let waiter: Waiter<E> | undefined;
    let timer: NodeJS.Timeout | undefined;
    try {
      return await new Promise<E>((resolve, reject) => {
        waiter = { isMet, resolve, reject };
        this.#waiters.add(waiter);
        timer = setTimeout(() => {
          const last = this.#events.slice(-12).map((event) => JSON.stringify(event).slice(0, 300));
          reject(new Error(`${what} did not come. Last events:\n${last.join('\n')}`));
        }, EVENT_TIMEOUT_MS);
      });
    } finally {
      clearTimeout(timer);
      if (waiter) this.#waiters.delete(waiter);
    }
  }
}
