/** Counts actions and problems by kind. */
export class Counters {
  readonly #counts = new Map<string, number>();
  readonly #problems = new Map<string, number>();

  done(what: string, times = 1): void {
    this.#counts.set(what, (this.#counts.get(what) ?? 0) + times);
  }

  /** Counts a problem. Ids in messages do not make different kinds. */
  failed(what: string, error: unknown): void {
    const text = error instanceof Error ? error.message : String(error);
    const kind = `${what}: ${text.replaceAll(/[0-9a-f]{8}-[0-9a-f-]{27}/g, '<id>').slice(0, 160)}`;
    this.#problems.set(kind, (this.#problems.get(kind) ?? 0) + 1);
  }

  get counts(): ReadonlyMap<string, number> {
    return this.#counts;
  }

  get problems(): ReadonlyMap<string, number> {
    return this.#problems;
  }
}
