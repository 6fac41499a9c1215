/** How values are drawn while the canvas rests, or while it is moved. */
interface Pace {
  /** Rounds through all that is in view, Hz. */
  readonly hz: number;
  /** A frame that takes longer on the page's thread leaves no room for what else is due, milliseconds. */
  readonly frameMs: number;
  /** Drawn in one frame at least, on the slowest machine, so that values go on. */
  readonly least: number;
  /** Drawn in one frame at most. */
  readonly most: number;
  /** Something is drawn in one frame of so many. */
  readonly frames: number;
}

const RESTING: Pace = { hz: 6, frameMs: 10, least: 1, most: 16, frames: 1 };
/** Values that change faster cannot be read. The first value costs a frame as much as the next ten. */
const MOVING: Pace = { hz: 1, frameMs: 30, least: 8, most: 16, frames: 6 };
/** What is not in view is drawn in one round of so many, and not while the canvas is moved. */
const ROUNDS_OUT_OF_VIEW = 3;

/**
 * Divides drawing into slices: hundreds of values in one frame would take as long as several frames. A
 * frame draws a few, in the order in which they come, as many as the frames before left room for.
 */
export class DrawSlices<T> {
  readonly #all: () => readonly T[];
  readonly #isInView: (one: T) => boolean;
  #round: readonly T[] = [];
  /** How far the round is. */
  #at = 0;
  #rounds = 0;
  #frame = 0;
  #beganMs = -Infinity;
  #size = RESTING.least;
  #drawn = 0;
  #pace = RESTING;

  /** @param all what is drawn, asked for when a round begins */
  constructor(all: () => readonly T[], isInView: (one: T) => boolean) {
    this.#all = all;
    this.#isInView = isInView;
  }

  /** What is drawn in this frame. */
  next(nowMs: number, isMoving: boolean): readonly T[] {
    const pace = isMoving ? MOVING : RESTING;
    if (pace !== this.#pace) {
      this.#pace = pace;
      this.#size = pace.least;
      this.#round = [];
    }
    this.#frame += 1;
    if (this.#frame % pace.frames !== 0) return [];
    if (this.#at >= this.#round.length) {
      if (nowMs - this.#beganMs < 1000 / pace.hz) return [];
      const isForAll = !isMoving && this.#rounds % ROUNDS_OUT_OF_VIEW === 0;
      this.#round = this.#all().filter((one) => isForAll || this.#isInView(one));
      this.#at = 0;
      this.#rounds += 1;
      this.#beganMs = nowMs;
    }
    const from = this.#at;
    this.#at += this.#size;
    const slice = this.#round.slice(from, this.#at);
    this.#drawn = slice.length;
    return slice;
  }

  /** @param frameMs how long the frame took in which the last slice was drawn */
  took(frameMs: number): void {
    const { least, most } = this.#pace;
    if (frameMs > this.#pace.frameMs) this.#size = Math.max(least, Math.floor(this.#drawn / 2));
    // A smaller slice says nothing about a larger one.
    else if (this.#drawn === this.#size) this.#size = Math.min(most, this.#size + 1);
  }
}
