/** Work that goes on until it is over; whoever works looks whether it goes on. */
export class Shift {
  #isOver = false;
  readonly #workers: Promise<void>[] = [];

  get goesOn(): boolean {
    return !this.#isOver;
  }

  /** @param work does one turn; what it throws ends nothing, and goes to `onProblem` */
  employ(work: () => Promise<void>, onProblem: (error: unknown) => void): void {
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

  /** Ends it, after the turns that are under way. */
  async end(): Promise<void> {
    this.#isOver = true;
    await Promise.all(this.#workers);
  }
}
