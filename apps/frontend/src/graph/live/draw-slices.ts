/** Rates and limits for drawing values, while the canvas is at rest or moving. */
interface Pace {
  /** Rate at which every visible value is drawn, Hz. */
  readonly hz: number;
  /** Longest time on the main thread that leaves room for other tasks, milliseconds per frame. */
  readonly frameMs: number;
  /** Smallest number of values per slice, on the slowest computer, so that all are drawn eventually. */
  readonly least: number;
  /** Largest number of values per slice. */
  readonly most: number;
  /** Number of frames per slice. */
  readonly frames: number;
}

const RESTING: Pace = { hz: 6, frameMs: 10, least: 1, most: 16, frames: 1 };
/** Values that change faster are unreadable. The first value of a frame costs as much as the next ten. */
const MOVING: Pace = { hz: 1, frameMs: 30, least: 8, most: 16, frames: 6 };
/** Values outside the view are drawn in one of this number of rounds, and not while the canvas moves. */
const ROUNDS_OUT_OF_VIEW = 3;

/**
 * Divides drawing into slices: hundreds of values in one frame would take as long as several frames. Each frame draws a
 * few in order, as many as previous frames had time for.
 */
export class DrawSlices<T> {
  readonly #all: () => readonly T[];
  readonly #isInView: (one: T) => boolean;
  #round: readonly T[] = [];
  /** Index of the next value in this round. */
  #at = 0;
  #rounds = 0;
  #frame = 0;
  #beganMs = -Infinity;
  #size = RESTING.least;
  #drawn = 0;
  #pace = RESTING;

  /** @param all returns the values to draw; called at the start of each round */
  constructor(all: () => readonly T[], isInView: (one: T) => boolean) {
    this.#all = all;
    this.#isInView = isInView;
  }

  /** Returns the values to draw in this frame. */
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

  /** @param frameMs duration of the frame that drew the last slice */
  took(frameMs: number): void {
    const { least, most } = this.#pace;
    if (frameMs > this.#pace.frameMs) this.#size = Math.max(least, Math.floor(this.#drawn / 2));
    // Only full slices show that a larger one is possible.
    else if (this.#drawn === this.#size) this.#size = Math.min(most, this.#size + 1);
  }
}
