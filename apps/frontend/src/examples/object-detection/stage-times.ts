/** Stage in the processing of a picture, from exposure to display. */
export interface Stage {
  readonly name: string;
  /** Kind: transfer of the picture, work of the module, transfer of the result. */
  readonly kind: 'picture' | 'module' | 'result';
  /** Mean of the results around the median total, milliseconds. */
  readonly ms: number;
  /** Possible error, milliseconds: the stage starts on one computer and ends on another, whose clocks differ. */
  readonly errorMs?: number | undefined;
}

export interface StageSummary {
  readonly stages: readonly Stage[];
  /** Age of a result when it is drawn, milliseconds. */
  readonly p50Ms: number;
  readonly p95Ms: number;
  /** Number of results in the window. */
  readonly count: number;
}

interface Sample {
  readonly atMs: number;
  /** `undefined` where it was not measured. */
  readonly parts: readonly (number | undefined)[];
  readonly totalMs: number;
}

/** In order. */
export const STAGES = [
  { name: 'Capture', kind: 'picture' },
  { name: 'Encode', kind: 'picture' },
  { name: 'To the module', kind: 'picture' },
  { name: 'Decode', kind: 'module' },
  { name: 'Detect', kind: 'module' },
  { name: 'Back', kind: 'result' },
  { name: 'Draw', kind: 'result' },
] as const;
/** Stages that start on one computer and end on another. */
const CROSSING: ReadonlySet<string> = new Set(['To the module', 'Back']);
/** Length of the window, milliseconds. */
const WINDOW_MS = 10_000;
const MAX_SAMPLES = 400;
/** Share of the results on either side of the median that determine the stages. */
const TYPICAL_SHARE = 0.1;

/** Timestamps of a result, milliseconds of the master's clock. */
export interface ResultTimes {
  /** Capture time of the picture: the timestamp of the result. */
  readonly takenMs: number;
  /** Time from exposure to encoder; `undefined` where the camera does not report it. */
  readonly captureMs?: number | undefined;
  /** Encoding time of the picture; 0 for pictures of other clients. */
  readonly encodeMs: number;
  /** Time at which the module finished: the timestamp of its duration. */
  readonly finishedMs: number;
  /** Duration of decoding and detection. */
  readonly durationMs: number;
  /** Duration of decoding; `undefined` when the module does not report it. */
  readonly decodeMs?: number | undefined;
  readonly arrivedMs: number;
  readonly drawnMs: number;
}

/** Durations of all stages, from the results of the last ten seconds. */
export class StageTimes {
  #samples: Sample[] = [];
  #sinceMs = -Infinity;

  add(times: ResultTimes): void {
    const { takenMs, captureMs, encodeMs, finishedMs, durationMs, decodeMs } = times;
    const { arrivedMs, drawnMs } = times;
    const parts = [
      captureMs,
      encodeMs,
      finishedMs - durationMs - takenMs - encodeMs - (captureMs ?? 0),
      decodeMs,
      durationMs - (decodeMs ?? 0),
      arrivedMs - finishedMs,
      drawnMs - arrivedMs,
      // Clocks agree to about a millisecond: shorter durations can come out negative.
    ].map((ms) => (ms === undefined ? undefined : Math.max(0, ms)));
    if (!this.counts(takenMs)) return;
    if (parts.some((ms) => ms !== undefined && !Number.isFinite(ms))) return;
    if (this.#samples.length >= MAX_SAMPLES) this.#samples.shift();
    this.#samples.push({ atMs: drawnMs, parts, totalMs: Math.max(0, drawnMs - takenMs) });
  }

  /**
   * Drops all results after a change of source or node.
   *
   * @param sinceMs ignores pictures taken before, whose results are still to come
   */
  clear(sinceMs = -Infinity): void {
    this.#samples = [];
    this.#sinceMs = sinceMs;
  }

  /** Whether a picture belongs to the current measurement. */
  counts(takenMs: number): boolean {
    return takenMs >= this.#sinceMs;
  }

  /**
   * @param errorMs possible difference of the clocks of page and module's node; `undefined` for the same clock
   * @returns `undefined` without results in the last ten seconds
   */
  summary(nowMs: number, errorMs?: number): StageSummary | undefined {
    this.#samples = this.#samples.filter(({ atMs }) => nowMs - atMs <= WINDOW_MS);
    if (this.#samples.length === 0) return undefined;
    const sorted = this.#samples.toSorted((a, b) => a.totalMs - b.totalMs);
    const totals = sorted.map(({ totalMs }) => totalMs);
    const typical = middle(sorted);
    return {
      stages: STAGES.flatMap((stage, index) => {
        const known = typical.flatMap(({ parts }) => parts[index] ?? []);
        if (known.length === 0) return [];
        const ms = known.reduce((sum, part) => sum + part, 0) / known.length;
        return CROSSING.has(stage.name) && errorMs !== undefined
          ? [{ ...stage, ms, errorMs }]
          : [{ ...stage, ms }];
      }),
      p50Ms: percentile(totals, 0.5),
      p95Ms: percentile(totals, 0.95),
      count: totals.length,
    };
  }
}

/** Returns the results around the median: their stages add up to it, unlike the medians of the stages. */
function middle(sorted: readonly Sample[]): readonly Sample[] {
  const center = Math.ceil(0.5 * sorted.length) - 1;
  const reach = Math.floor(sorted.length * TYPICAL_SHARE);
  return sorted.slice(Math.max(0, center - reach), center + reach + 1);
}

/** @param sorted ascending */
function percentile(sorted: readonly number[], share: number): number {
  return sorted[Math.ceil(share * sorted.length) - 1]!;
}
