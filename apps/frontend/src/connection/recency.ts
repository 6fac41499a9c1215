/**
 * Orders updates for the same id: replies may arrive out of order, and announcements in between are newer than both.
 */
export class Recency {
  #turn = 0;
  readonly #turns = new Map<string, number>();

  /** Time of a request or an announcement. */
  now(): number {
    return (this.#turn += 1);
  }

  /** @returns false when the id has an update newer than `turn` */
  accepts(id: string, turn: number): boolean {
    if ((this.#turns.get(id) ?? 0) > turn) return false;
    this.#turns.set(id, turn);
    return true;
  }
}
