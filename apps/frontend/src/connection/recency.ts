/**
 * Tells which of two things is newer that became known of the same id: answers may overtake each other, and what is
 * announced meanwhile is newer than both.
 */
export class Recency {
  #turn = 0;
  readonly #turns = new Map<string, number>();

  /** The moment of a question, or of an announcement. */
  now(): number {
    return (this.#turn += 1);
  }

  /** @returns false when something newer than `turn` is known of the id */
  accepts(id: string, turn: number): boolean {
    if ((this.#turns.get(id) ?? 0) > turn) return false;
    this.#turns.set(id, turn);
    return true;
  }
}
