/** A part of the way of a picture, from light to screen. */
export interface Stage {
  readonly name: string;
  /** What happens: the picture travels, the module works, the result travels. */
  readonly kind: 'picture' | 'module' | 'result';
  /** Median, milliseconds. */
  readonly ms: number;
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
  readonly parts: readonly number[];
  readonly totalMs: number;
}

/** In the order of the way. */
export const STAGES = [
  { name: 'Encode', kind: 'picture' },
  { name: 'To the module', kind: 'picture' },
  { name: 'Detect', kind: 'module' },
  { name: 'Back', kind: 'result' },
  { name: 'Draw', kind: 'result' },
] as const;
/** Results of this time count, milliseconds. */
const WINDOW_MS = 10_000;
const MAX_SAMPLES = 400;

/** One result, all moments by the clock of the master, milliseconds. */
export interface ResultTimes {
  /** When the picture was taken: the timestamp of the result. */
  readonly takenMs: number;
  /** Making a record of the picture; 0 for pictures of other clients. */
  readonly encodeMs: number;
  /** When the module had finished: the timestamp of its duration. */
  readonly finishedMs: number;
  readonly durationMs: number;
  readonly arrivedMs: number;
  readonly drawnMs: number;
}

/** Percentiles of what each stage took, of the results of the last ten seconds. */
export class StageTimes {
  #samples: Sample[] = [];

  add(times: ResultTimes): void {
    const { takenMs, encodeMs, finishedMs, durationMs, arrivedMs, drawnMs } = times;
    const parts = [
      encodeMs,
      finishedMs - durationMs - takenMs - encodeMs,
      durationMs,
      arrivedMs - finishedMs,
      drawnMs - arrivedMs,
      // Clocks are known to a millisecond or so: what is shorter than that may come out below 0.
    ].map((ms) => Math.max(0, ms));
    if (parts.some((ms) => !Number.isFinite(ms))) return;
    if (this.#samples.length >= MAX_SAMPLES) this.#samples.shift();
    this.#samples.push({ atMs: drawnMs, parts, totalMs: Math.max(0, drawnMs - takenMs) });
  }

  /** Forgets everything: another source or place. */
  clear(): void {
    this.#samples = [];
  }

  /** @returns `undefined` without results in the last ten seconds */
  summary(nowMs: number): StageSummary | undefined {
    this.#samples = this.#samples.filter(({ atMs }) => nowMs - atMs <= WINDOW_MS);
    if (this.#samples.length === 0) return undefined;
    const totals = this.#samples.map(({ totalMs }) => totalMs);
    return {
      stages: STAGES.map((stage, index) => ({
        ...stage,
        ms: percentile(
          this.#samples.map(({ parts }) => parts[index]!),
          0.5,
        ),
      })),
      p50Ms: percentile(totals, 0.5),
      p95Ms: percentile(totals, 0.95),
      count: totals.length,
    };
  }
}

function percentile(values: readonly number[], share: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.ceil(share * sorted.length) - 1]!;
}
