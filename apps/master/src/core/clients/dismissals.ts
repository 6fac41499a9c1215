import type { CloseReason } from '../ports/close-reason.ts';

/** Clients remembered: more than can be removed by hand while one is away. */
const MAX_REMEMBERED = 1_000;

/** Why a client was removed. */
export interface Dismissal {
  readonly reason: CloseReason;
  /** For its user: who did it, and why. */
  readonly explanation?: string;
}

/** Removed clients, with the reason that they get when they open a socket again [EX-30]. */
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

  /** The reason why this client was removed; undefined when it was not removed. */
  of(clientId: string): Dismissal | undefined {
    return this.#reasons.get(clientId);
  }

  /** The client registers again at the request of its user. */
  forget(clientId: string): void {
    this.#reasons.delete(clientId);
  }
}
