/** Counts of actions and of problems, by kind. */
export class Tally {
  readonly #counts = new Map<string, number>();
  readonly #problems = new Map<string, number>();

  done(what: string, times = 1): void {
    this.#counts.set(what, (this.#counts.get(what) ?? 0) + times);
  }

  /** Ids in messages make no kinds of their own. */
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
