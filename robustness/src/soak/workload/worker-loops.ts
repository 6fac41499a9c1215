/** Functions that run again and again, in parallel, until `end`. */
export class WorkerLoops {
  #isOver = false;
  readonly #workers: Promise<void>[] = [];

  /** Starts a loop. @param work one iteration; what it throws goes to `onProblem`, and the loop continues */
  add(work: () => Promise<void>, onProblem: (error: unknown) => void): void {
    const keepOn = async (): Promise<void> => {
      while (!this.#isOver) {
        try {
          await work();
        } catch (error) {
          onProblem(error);
          await new Promise((resolve) => setTimeout(resolve, 200));
        }
      }
    };
    this.#workers.push(keepOn());
  }

  /** Ends all loops after their current iteration. */
  async end(): Promise<void> {
    this.#isOver = true;
    await Promise.all(this.#workers);
  }
}
