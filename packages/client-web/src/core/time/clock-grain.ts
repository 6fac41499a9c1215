/** Steps in which clocks of browsers and of Node are known to go on, milliseconds, coarsest first. */
const GRAINS_MS = [1, 0.1, 0.02] as const;
const FINEST_MS = 0.005;
/** Fractions of a number this large are rounded. */
const ROUNDING = 1e-3;

/** Finds out in which steps a clock goes on, from what it said so far: pages get coarse clocks. */
export class ClockGrain {
  #index = 0;

  /** The step, milliseconds. */
  get grainMs(): number {
    return GRAINS_MS[this.#index] ?? FINEST_MS;
  }

  add(readingMs: number): void {
    for (let grainMs = GRAINS_MS[this.#index]; grainMs !== undefined;) {
      const steps = readingMs / grainMs;
      if (Math.abs(steps - Math.round(steps)) < ROUNDING) return;
      this.#index += 1;
      grainMs = GRAINS_MS[this.#index];
    }
  }
}
