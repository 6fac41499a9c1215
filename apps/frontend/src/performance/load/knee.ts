/** Measurements of a step of the ramp. */
export interface LoadStep {
  /** Requested records per second. */
  readonly wantedHz: number;
  /** Published records per second. */
  readonly sentHz: number;
  /** Deliveries per second. */
  readonly deliveredHz: number;
  /** Share of deliveries that did not arrive, 0 to 1. */
  readonly lostShare: number;
  readonly p50Ms: number;
  readonly p95Ms: number;
  readonly p99Ms: number;
  /** Timer delay in the load generator, milliseconds: a measure of how busy the browser itself was. */
  readonly lagP95Ms: number;
  /** CPU use of the master, percent of one core; `undefined` when it does not report it. */
  readonly masterCpuPercent: number | undefined;
}

/** Reason why a step is worse than the previous ones. */
export type StepTrouble = 'latency' | 'losses' | 'browser';

export interface Knee {
  /** Index of the last good step; -1 when there was none. */
  readonly lastGood: number;
  /** Index of the first bad step; `undefined` when all were good. */
  readonly firstBad: number | undefined;
  readonly trouble: StepTrouble | undefined;
  /** True when the browser was the limit: the system may handle more than this page can generate. */
  readonly isBrowser: boolean;
}

/** Latency has increased when p95 is this many times the lowest of the previous steps, */
const RISE = 3;
/** and at least by this, milliseconds: smaller differences are below the resolution of timers. */
const MIN_RISE_MS = 5;
/** Highest acceptable share of lost deliveries. */
const MAX_LOST = 0.005;
/** Lowest share of the requested rate that must be published; below, the browser is the limit. */
const MIN_SENT = 0.9;
/** Share of the latency increase that the delay of the load generator must explain. */
const LAG_SHARE = 0.5;

/** Returns the problem of a step, compared with the lowest p95 of the previous steps. */
export function troubleOf(step: LoadStep, lowestP95Ms: number): StepTrouble | undefined {
  if (step.sentHz < MIN_SENT * step.wantedHz) return 'browser';
  if (step.lostShare > MAX_LOST) return 'losses';
  const isRisen = step.p95Ms > Math.max(RISE * lowestP95Ms, lowestP95Ms + MIN_RISE_MS);
  return isRisen ? 'latency' : undefined;
}

/**
 * Finds the step where latency starts to increase: the last good one before two consecutive bad ones, so that a single
 * outlier is ignored; at the end of the ramp one suffices.
 */
export function findKnee(steps: readonly LoadStep[]): Knee {
  let lowestP95Ms = Infinity;
  const troubles = steps.map((step) => {
    const trouble = troubleOf(step, lowestP95Ms === Infinity ? step.p95Ms : lowestP95Ms);
    if (step.p95Ms < lowestP95Ms) lowestP95Ms = step.p95Ms;
    return trouble;
  });
  const firstBad = troubles.findIndex(
    (trouble, index) =>
      trouble !== undefined && (index === troubles.length - 1 || troubles[index + 1] !== undefined),
  );
  if (firstBad === -1) {
    return {
      lastGood: steps.length - 1,
      firstBad: undefined,
      trouble: undefined,
      isBrowser: false,
    };
  }
  const { lagP95Ms, p95Ms } = steps[firstBad]!;
  const trouble = troubles[firstBad];
  return {
    lastGood: firstBad - 1,
    firstBad,
    trouble,
    isBrowser: trouble === 'browser' || lagP95Ms > LAG_SHARE * p95Ms,
  };
}
