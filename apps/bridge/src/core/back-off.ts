const FIRST_MS = 500;
const MAX_MS = 30_000;

/** Pauses before attempts to connect: each twice as long as the one before, up to 30 s, with a part by chance. [BR-40] */
export class BackOff {
  readonly #random: () => number;
  #attempts = 0;

  /** @param random at least 0 and below 1 */
  constructor(random: () => number) {
    this.#random = random;
  }

  /** Returns the next pause, milliseconds. */
  nextMs(): number {
    const pauseMs = Math.min(MAX_MS, FIRST_MS * 2 ** this.#attempts++);
    return Math.round(pauseMs * (0.75 + 0.5 * this.#random()));
  }

  handleConnected(): void {
    this.#attempts = 0;
  }
}
