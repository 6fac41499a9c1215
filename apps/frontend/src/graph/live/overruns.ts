import type { ModuleStatistics } from '@ubii/proto';

/** Time in which overruns are counted, milliseconds. */
const WINDOW_MS = 5000;
/** A module is late when at least this many runs were left out, and this share of all. */
const MIN_OVERRUNS = 3;
const MIN_SHARE = 0.1;

type Report = Pick<ModuleStatistics, 'moduleId' | 'runs' | 'overruns'>;
interface Sample {
  readonly timeMs: number;
  readonly runs: number;
  readonly overruns: number;
}

/** Finds the modules that are slower than their frequency, from their reports. [PM-22] */
export class Overruns {
  readonly #samples = new Map<string, readonly Sample[]>();

  /** Takes a report of a module. @returns whether it is late now */
  report({ moduleId, runs, overruns }: Report, timeMs: number): boolean {
    const now = { timeMs, runs, overruns };
    const kept = (this.#samples.get(moduleId) ?? []).filter(
      // A lower count is from before a restart.
      (one) => timeMs - one.timeMs <= WINDOW_MS && one.runs <= runs,
    );
    this.#samples.set(moduleId, [...kept, now]);
    const [first = now] = kept;
    const skipped = overruns - first.overruns;
    return skipped >= MIN_OVERRUNS && skipped >= MIN_SHARE * (runs - first.runs + skipped);
  }

  /** Forgets a module that is gone. */
  forget(moduleId: string): void {
    this.#samples.delete(moduleId);
  }
}
