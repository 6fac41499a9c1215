/** Time after which a signal is over, milliseconds; a session repeats it while a touch is near. */
const HOLDS_MS = 1_500;

/**
 * True while a session reports that another touch is near. A session that is stopped or lost its node sends
 * no final value, so that a value is valid only for a short time.
 */
export class NearSignal {
  readonly #show: (isNear: boolean) => void;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(show: (isNear: boolean) => void) {
    this.#show = show;
  }

  handle(isNear: boolean): void {
    this.end();
    if (isNear) this.#timer = setTimeout(() => this.#show(false), HOLDS_MS);
    this.#show(isNear);
  }

  /** Ends the signal at once. */
  end(): void {
    clearTimeout(this.#timer);
  }
}
