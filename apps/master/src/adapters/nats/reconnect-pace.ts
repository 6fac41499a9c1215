/** Delays before a connection is tried again, milliseconds: each twice the one before. */
const FIRST_MS = 50;
const LONGEST_MS = 2_000;

/** How long to wait before a lost connection is tried again: longer each time, and never all masters at once. */
export class ReconnectPace {
  readonly #random: () => number;
  #attempts = 0;

  /** @param random from 0 to 1. Default: `Math.random` */
  constructor(random: () => number = Math.random) {
    this.#random = random;
  }

  handleAttempt(): void {
    this.#attempts += 1;
  }

  handleSuccess(): void {
    this.#attempts = 0;
  }

  delayMs(): number {
    const longest = Math.min(LONGEST_MS, FIRST_MS * 2 ** Math.min(this.#attempts, 16));
    return Math.round(longest * (0.5 + this.#random() / 2));
  }
}
