/** Done in one frame, so that those who look at it see it move. */
const PER_FRAME = 4;

/** Does what can wait in the frames that come, a few in each, first come first. */
export class FrameQueue {
  #jobs: (() => void)[] = [];
  #frame: number | undefined;

  add(job: () => void): void {
    this.#jobs.push(job);
    this.#frame ??= requestAnimationFrame(this.#next);
  }

  /** Forgets what is not done yet. */
  clear(): void {
    this.#jobs = [];
    if (this.#frame !== undefined) cancelAnimationFrame(this.#frame);
    this.#frame = undefined;
  }

  readonly #next = (): void => {
    for (const job of this.#jobs.splice(0, PER_FRAME)) job();
    this.#frame = this.#jobs.length > 0 ? requestAnimationFrame(this.#next) : undefined;
  };
}
