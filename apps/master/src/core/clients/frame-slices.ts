import type { Clock } from '@ubii/timing';

/** Frames of one client that are read in slices. */
export interface SlicedFrames {
  /** Reads some slices. @returns whether all were read */
  readSlice(): boolean;
}

/**
 * Reads large frames of all clients in slices: one slice in each turn of the event loop, of one client after the
 * other. However many clients send large frames, other work waits for one slice. [TD-71]
 */
export class FrameSlices {
  readonly #clock: Pick<Clock, 'atEndOfTurn'>;
  /** In the order of their turns. */
  readonly #waiting = new Set<SlicedFrames>();
  #isScheduled = false;

  constructor(clock: Pick<Clock, 'atEndOfTurn'>) {
    this.#clock = clock;
  }

  add(frames: SlicedFrames): void {
    this.#waiting.add(frames);
    this.#schedule();
  }

  remove(frames: SlicedFrames): void {
    this.#waiting.delete(frames);
  }

  #schedule(): void {
    if (this.#isScheduled || this.#waiting.size === 0) return;
    this.#isScheduled = true;
    this.#clock.atEndOfTurn(this.#readNext);
  }

  readonly #readNext = (): void => {
    this.#isScheduled = false;
    for (const frames of this.#waiting) {
      this.#waiting.delete(frames);
      if (!frames.readSlice()) this.#waiting.add(frames);
      break;
    }
    this.#schedule();
  };
}
