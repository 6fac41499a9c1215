/** A frame after which a screen with 60 Hz has missed one, milliseconds. */
const LATE_MS = 25;
const MOST = 8;

/** Does what can wait in the frames that come, first come first: more in each while they are in time. */
export class FrameQueue {
  #jobs: (() => void)[] = [];
  #frame: number | undefined;
  #size = 1;
  #lastMs = Infinity;

  add(job: () => void): void {
    this.#jobs.push(job);
    this.#frame ??= requestAnimationFrame(this.#next);
  }

  /** Forgets what is not done yet. */
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
