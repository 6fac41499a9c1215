/** A part of the way of a picture, from light to screen. */
export interface Stage {
  readonly name: string;
  /** What happens: the picture travels, the module works, the result travels. */
  readonly kind: 'picture' | 'module' | 'result';
  /** Mean of the results around the median of the whole, milliseconds. */
  readonly ms: number;
  /** How far it may be from that: the stage begins on one machine and ends on another, whose clocks differ. Milliseconds. */
  readonly errorMs?: number | undefined;
}

export interface StageSummary {
  readonly stages: readonly Stage[];
  /** Age of a result when it is drawn, milliseconds. */
  readonly p50Ms: number;
  readonly p95Ms: number;
  /** Results in the window. */
  readonly count: number;
}

interface Sample {
  readonly atMs: number;
  /** `undefined` where it was not measured. */
  readonly parts: readonly (number | undefined)[];
  readonly totalMs: number;
}

/** In the order of the way. */
export const STAGES = [
  { name: 'Capture', kind: 'picture' },
  { name: 'Encode', kind: 'picture' },
  { name: 'To the module', kind: 'picture' },
  { name: 'Decode', kind: 'module' },
  { name: 'Detect', kind: 'module' },
  { name: 'Back', kind: 'result' },
  { name: 'Draw', kind: 'result' },
] as const;
/** Those that begin on one machine and end on another. */
const CROSSING: ReadonlySet<string> = new Set(['To the module', 'Back']);
/** Results of this time count, milliseconds. */
const WINDOW_MS = 10_000;
const MAX_SAMPLES = 400;
/** Of all results, how many on either side of the median tell what the parts are. */
const TYPICAL_SHARE = 0.1;

/** One result, all moments by the clock of the master, milliseconds. */
export interface ResultTimes {
  /** When the picture was taken: the timestamp of the result. */
  readonly takenMs: number;
  /** From the light to the encoder; `undefined` where no camera tells. */
  readonly captureMs?: number | undefined;
  /** Making a record of the picture; 0 for pictures of other clients. */
  readonly encodeMs: number;
  /** When the module had finished: the timestamp of its duration. */
  readonly finishedMs: number;
  /** Decoding and detection. */
  readonly durationMs: number;
  /** Decoding alone; `undefined` when the module does not tell. */
  readonly decodeMs?: number | undefined;
  readonly arrivedMs: number;
  readonly drawnMs: number;
}

/** What each stage took, of the results of the last ten seconds. */
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
      // Clocks are known to a millisecond or so: what is shorter than that may come out below 0.
    ].map((ms) => (ms === undefined ? undefined : Math.max(0, ms)));
    if (!this.counts(takenMs)) return;
    if (parts.some((ms) => ms !== undefined && !Number.isFinite(ms))) return;
    if (this.#samples.length >= MAX_SAMPLES) this.#samples.shift();
    this.#samples.push({ atMs: drawnMs, parts, totalMs: Math.max(0, drawnMs - takenMs) });
  }

  /**
   * Forgets everything: another source or place.
   *
   * @param sinceMs pictures that were taken before do not count: they are on their way still
   */
  clear(sinceMs = -Infinity): void {
    this.#samples = [];
    this.#sinceMs = sinceMs;
  }

  /** Whether a picture belongs to what is measured. */
  counts(takenMs: number): boolean {
    return takenMs >= this.#sinceMs;
  }

  /**
   * @param errorMs how far the clocks of this page and of the module's node may be apart; `undefined` when it is one clock
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

/** The results around the median: their parts add up to it, which medians of the parts do not. */
function middle(sorted: readonly Sample[]): readonly Sample[] {
  const center = Math.ceil(0.5 * sorted.length) - 1;
  const reach = Math.floor(sorted.length * TYPICAL_SHARE);
  return sorted.slice(Math.max(0, center - reach), center + reach + 1);
}

/** @param sorted ascending */
function percentile(sorted: readonly number[], share: number): number {
  return sorted[Math.ceil(share * sorted.length) - 1]!;
}
