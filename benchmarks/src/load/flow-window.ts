/**
 * Keeps count of how far the slowest of many subscribers is, at a cost per step that does not grow
 * with their number.
 */
export class FlowWindow {
  /** Subscribers by the number of the record they expect next, modulo the ring's length. */
  readonly #subscribersAt: Uint32Array;
  readonly #mask: number;
  #slowest = 0;

  /**
   * @param subscribers how many there are, all at record 0
   * @param window the most records the fastest is ahead of the slowest
   */
  constructor(subscribers: number, window: number) {
    const length = 2 ** Math.ceil(Math.log2(window + 1));
    this.#mask = length - 1;
    this.#subscribersAt = new Uint32Array(length);
    this.#subscribersAt[0] = subscribers;
  }

  /** Number of the record the slowest subscriber expects next: all before it have reached all. */
  get slowest(): number {
    return this.#slowest;
  }

  /** One subscriber went on. Returns true when the slowest did. */
  advance(from: number, to: number): boolean {
    const counts = this.#subscribersAt;
    counts[from & this.#mask]! -= 1;
    counts[to & this.#mask]! += 1;
    const before = this.#slowest;
    while (this.#slowest < to && counts[this.#slowest & this.#mask] === 0) this.#slowest += 1;
    return this.#slowest !== before;
  }
}
