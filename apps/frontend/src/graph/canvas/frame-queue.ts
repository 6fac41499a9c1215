/** Duration from which a frame is late on a 60 Hz screen, milliseconds. */
const LATE_MS = 25;
const MOST = 8;

/** Runs deferred tasks in the next frames, in order; more per frame as long as frames are on time. */
export class FrameQueue {
  #jobs: (() => void)[] = [];
  #frame: number | undefined;
  #size = 1;
  #lastMs = Infinity;

  add(job: () => void): void {
    this.#jobs.push(job);
    this.#frame ??= requestAnimationFrame(this.#next);
  }

  /** Drops all pending tasks. */
  clear(): void {
    this.#jobs = [];
    this.#end();
  }

  readonly #next = (timeMs: number): void => {
    const isLate = timeMs - this.#lastMs > LATE_MS;
    this.#size = isLate ? Math.ceil(this.#size / 2) : Math.min(MOST, this.#size + 1);
    this.#lastMs = timeMs;
    for (const job of this.#jobs.splice(0, this.#size)) job();
    if (this.#jobs.length > 0) this.#frame = requestAnimationFrame(this.#next);
    else this.#end();
  };

  #end(): void {
    if (this.#frame !== undefined) cancelAnimationFrame(this.#frame);
    this.#frame = undefined;
    this.#size = 1;
    this.#lastMs = Infinity;
  }
}
