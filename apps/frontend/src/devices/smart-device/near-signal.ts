/** A session says again and again that somebody is near; one that says nothing for so long has ended, milliseconds. */
const HOLDS_MS = 1_500;

/**
 * Whether somebody is near, as a session says it. A session that is stopped, or whose node is gone, says
 * no last word: what it said holds only for a moment.
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
