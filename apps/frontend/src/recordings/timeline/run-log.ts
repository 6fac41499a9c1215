/** Something that held for a while: a text, a thing that was seen, a key that was down. */
export interface Run {
  readonly label: string;
  readonly fromMs: number;
  readonly untilMs: number;
  /** Which row of the track it has. */
  readonly lane: number;
}

/** Runs kept of a track. More are narrower than a pixel in any view of it all. */
const MAX_RUNS = 20_000;

interface OpenRun {
  readonly fromMs: number;
  readonly lane: number;
  untilMs: number;
}

/** Makes runs of the states of a track's records, in the order of time. */
export class RunLog {
  readonly #runs: Run[] = [];
  readonly #open = new Map<string, OpenRun>();
  readonly #lastMs: number[] = [];
  readonly #maxLanes: number;
  readonly #gapMs: number;

  /**
   * @param maxLanes rows; what does not fit shares the last
   * @param gapMs a state ends when no record comes for this long
   */
  constructor(maxLanes: number, gapMs: number) {
    this.#maxLanes = maxLanes;
    this.#gapMs = gapMs;
  }

  add(timeMs: number, states: readonly string[]): void {
    for (const [label, run] of this.#open) {
      const isSilent = timeMs - run.untilMs > this.#gapMs;
      if (!isSilent) run.untilMs = timeMs;
      if (isSilent || !states.includes(label)) this.#end(label, run);
    }
    for (const label of states) {
      if (this.#open.has(label) || this.#runs.length >= MAX_RUNS) continue;
      const lane = this.#freeLane(timeMs);
      this.#open.set(label, { fromMs: timeMs, untilMs: timeMs, lane });
    }
  }

  /** All so far. @param nowMs until when the newest records were read */
  runs(nowMs: number): Run[] {
    const open = [...this.#open].map(([label, { fromMs, untilMs, lane }]) => ({
      label,
      fromMs,
      lane,
      untilMs: Math.max(untilMs, Math.min(nowMs, untilMs + this.#gapMs)),
    }));
    return [...this.#runs, ...open].sort((a, b) => a.fromMs - b.fromMs);
  }

  #end(label: string, { fromMs, untilMs, lane }: OpenRun): void {
    this.#open.delete(label);
    this.#runs.push({ label, fromMs, untilMs, lane });
    this.#lastMs[lane] = untilMs;
  }

  #freeLane(timeMs: number): number {
    const taken = new Set([...this.#open.values()].map(({ lane }) => lane));
    for (let lane = 0; lane < this.#maxLanes - 1; lane++) {
      if (!taken.has(lane) && (this.#lastMs[lane] ?? 0) <= timeMs) return lane;
    }
    return this.#maxLanes - 1;
  }
}
