/** Clients remembered: more than can be removed by hand while one is away. */
const MAX_REMEMBERED = 1_000;

/** What a client is told that somebody removed: a close code and why. */
export interface Dismissal {
  readonly code: number;
  readonly reason: string;
}

/** Clients that somebody removed, with what they are told when they come to a socket again [EX-30]. */
export class Dismissals {
  readonly #reasons = new Map<string, Dismissal>();

  add(clientId: string, dismissal: Dismissal): void {
    this.#reasons.delete(clientId);
    this.#reasons.set(clientId, dismissal);
    if (this.#reasons.size <= MAX_REMEMBERED) return;
    for (const oldest of this.#reasons.keys()) {
      this.#reasons.delete(oldest);
      return;
    }
  }

  /** Why this client was removed; undefined when nobody removed it. */
  of(clientId: string): Dismissal | undefined {
    return this.#reasons.get(clientId);
  }

  /** It registers anew: somebody asked it to. */
  forget(clientId: string): void {
    this.#reasons.delete(clientId);
  }
}
