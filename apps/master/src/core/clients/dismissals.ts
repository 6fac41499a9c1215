/** Clients remembered: more than can be removed by hand while one is away. */
const MAX_REMEMBERED = 1_000;

/** Clients that somebody removed, with what they are told when they come to a socket again [EX-30]. */
export class Dismissals {
  readonly #reasons = new Map<string, string>();

  add(clientId: string, reason: string): void {
    this.#reasons.delete(clientId);
    this.#reasons.set(clientId, reason);
    if (this.#reasons.size <= MAX_REMEMBERED) return;
    for (const oldest of this.#reasons.keys()) {
      this.#reasons.delete(oldest);
      return;
    }
  }

  /** Why this client was removed; undefined when nobody removed it. */
  reasonOf(clientId: string): string | undefined {
    return this.#reasons.get(clientId);
  }

  /** It registers anew: somebody asked it to. */
  forget(clientId: string): void {
    this.#reasons.delete(clientId);
  }
}
