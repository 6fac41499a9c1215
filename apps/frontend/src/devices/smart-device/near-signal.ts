/** A session repeats that a touch is near. Without a record for this time, it has ended, milliseconds. */
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

  /** Shows nothing more. */
  end(): void {
    clearTimeout(this.#timer);
  }
}
