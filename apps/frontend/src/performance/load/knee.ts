/** What one step of the ramp gave. */
export interface LoadStep {
  /** Records per second that were asked for. */
  readonly wantedHz: number;
  /** Records per second that were published. */
  readonly sentHz: number;
  /** Deliveries per second. */
  readonly deliveredHz: number;
  /** Share of the deliveries that did not come, 0 to 1. */
  readonly lostShare: number;
  readonly p50Ms: number;
  readonly p95Ms: number;
  readonly p99Ms: number;
  /** How late a timer of the load generator was, milliseconds: how busy the browser itself was. */
  readonly lagP95Ms: number;
  /** Share of one core the master used, percent; `undefined` when it did not say. */
  readonly masterCpuPercent: number | undefined;
}

/** What kept a step from being as the ones before. */
export type StepTrouble = 'latency' | 'losses' | 'browser';

export interface Knee {
  /** Index of the last step that was fine; -1 when none was. */
  readonly lastGood: number;
  /** Index of the first that was not; `undefined` when all were fine. */
  readonly firstBad: number | undefined;
  readonly trouble: StepTrouble | undefined;
  /** The browser was the limit: the system may take more than this page can make. */
  readonly isBrowser: boolean;
}

/** Latency has risen when p95 is this many times that of the quietest step before, */
const RISE = 3;
/** and at least so much more, milliseconds: below that people and timers see no difference. */
const MIN_RISE_MS = 5;
/** More than this share of the deliveries lost is no load that works. */
const MAX_LOST = 0.005;
/** Less than this share of the wanted rate published: the browser cannot make it. */
const MIN_SENT = 0.9;
/** Lag of the load generator that explains this share of the risen latency. */
const LAG_SHARE = 0.5;

/** What is wrong with a step, beside the lowest p95 of the steps before. */
export function troubleOf(step: LoadStep, lowestP95Ms: number): StepTrouble | undefined {
  if (step.sentHz < MIN_SENT * step.wantedHz) return 'browser';
  if (step.lostShare > MAX_LOST) return 'losses';
  const isRisen = step.p95Ms > Math.max(RISE * lowestP95Ms, lowestP95Ms + MIN_RISE_MS);
  return isRisen ? 'latency' : undefined;
}

/**
 * Finds where latency begins to rise: the last fine step before two that are not, so that one hiccup
 * is no knee; at the end of the ramp one is enough.
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
