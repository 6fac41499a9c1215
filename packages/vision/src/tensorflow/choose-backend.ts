import type { BackendName } from './backend-names.ts';

/** A backend to try. */
export interface BackendCandidate {
  readonly name: BackendName;
  /** Why the backend is unavailable; undefined when it can be tried. */
  readonly absence?: string;
  /** Tried only when it is requested or no other backend works, because it is slow. */
  readonly isLastResort?: boolean;
  /** Starts the backend. Rejects when that fails. */
  start(): Promise<void>;
  /** Runs the probe once. Resolves with the error of its numbers, a share of the largest number. */
  probe(): Promise<number>;
}

/** Result of trying one backend. */
export interface BackendTrial {
  readonly name: BackendName;
  readonly outcome: 'chosen' | 'slower' | 'wrong' | 'failed' | 'absent' | 'not tried';
  /** One sentence. */
  readonly reason: string;
  /** Duration of the start and the first run, which compiles; undefined when it was not started. */
  readonly startMs?: number;
  /** Duration of the shortest run of the probe; undefined without correct results. */
  readonly probeMs?: number;
}

/** The selected backend and the reason. */
export interface BackendChoice {
  readonly backend: BackendName;
  /** One sentence; says why the requested backend is not used. */
  readonly reason: string;
  /** All candidates, in the order in which they were tried. */
  readonly trials: readonly BackendTrial[];
  /** Backends that may be faster were not measured. */
  readonly isProvisional: boolean;
}

export interface ChooseBackendOptions {
  /** The requested backend, used when it works; default: the fastest. */
  readonly wanted?: BackendName;
  /** `wanted` is not a request but starts soonest: it computes until the others are measured. */
  readonly isProvisional?: boolean;
  /** Milliseconds of a steady clock. */
  readonly now: () => number;
}

/**
 * Largest accepted error of the probe, a share of the largest number. Graphics cards of phones compute
 * with 16-bit floats (11 bits of precision, 0.05 % per operation), which is enough for detectors; errors of
 * faulty backends are far above 1 %.
 */
export const MAX_PROBE_ERROR = 0.01;

/** The shortest of three runs counts: on a busy machine, single runs are not representative. */
const PROBE_RUNS = 3;
/** Slow backends get fewer runs, so that users do not notice the measurement at the start. */
const MAX_PROBING_MS = 300;

/**
 * Tries backends and selects the fastest one with correct results, or the requested one if it works.
 *
 * @throws Error when no backend works; the message contains all reasons
 */
export async function chooseBackend(
  candidates: readonly BackendCandidate[],
  { wanted, isProvisional: isSoonest = false, now }: ChooseBackendOptions,
): Promise<BackendChoice> {
  const order = [
    ...candidates.filter(({ name }) => name === wanted),
    ...candidates.filter(({ name, isLastResort }) => name !== wanted && isLastResort !== true),
    ...candidates.filter(({ name, isLastResort }) => name !== wanted && isLastResort === true),
  ];
  const trials: BackendTrial[] = [];
  for (const candidate of order) {
    const best = fastest(trials);
    const isDone = best !== undefined && (wanted === best.name || candidate.isLastResort === true);
    trials.push(
      isDone && candidate.absence === undefined
        ? { name: candidate.name, outcome: 'not tried', reason: `${best.name} works.` }
        : await tryBackend(candidate, now),
    );
  }
  const best = fastest(trials);
  if (best === undefined) {
    const reasons = trials.map(({ name, reason }) => `${name}: ${reason}`);
    throw new Error(`No backend of TensorFlow.js works here. ${reasons.join(' ')}`);
  }
  const isProvisional =
    isSoonest &&
    order.some(
      ({ isLastResort }, index) => isLastResort !== true && trials[index]!.outcome === 'not tried',
    );
  const refused = isSoonest
    ? undefined
    : trials.find(({ name }) => name === wanted && name !== best.name);
  return {
    backend: best.name,
    reason: isProvisional
      ? `${best.name} starts soonest; the others are measured after the first result.`
      : wanted === best.name && !isSoonest
        ? `${best.name} was asked for and works.`
        : refused === undefined
          ? `${best.name} is the fastest backend with right results.`
          : `${best.name} instead of ${refused.name}: ${refused.reason}`,
    isProvisional,
    trials: trials.map((trial) =>
      trial.outcome !== 'slower'
        ? trial
        : trial === best
          ? { ...trial, outcome: 'chosen' }
          : { ...trial, reason: `${best.name} is faster.` },
    ),
  };
}

/** Backends that work are `slower` until the fastest is known. */
async function tryBackend(candidate: BackendCandidate, now: () => number): Promise<BackendTrial> {
  const { name, absence } = candidate;
  if (absence !== undefined) return { name, outcome: 'absent', reason: absence };
  try {
    const startedAt = now();
    await candidate.start();
    const error = await candidate.probe();
    const startMs = now() - startedAt;
    if (!(error <= MAX_PROBE_ERROR)) {
      const reason = Number.isFinite(error)
        ? `Its numbers differ from the reference by ${(error * 100).toFixed(1)} %.`
        : 'Its results are not numbers.';
      return { name, outcome: 'wrong', reason, startMs };
    }
    let probeMs = Infinity;
    const probingSince = now();
    for (let run = 0; run < PROBE_RUNS && now() - probingSince < MAX_PROBING_MS; run++) {
      const at = now();
      await candidate.probe();
      probeMs = Math.min(probeMs, now() - at);
    }
    return { name, outcome: 'slower', reason: 'Its results are right.', startMs, probeMs };
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return { name, outcome: 'failed', reason: reason.endsWith('.') ? reason : `${reason}.` };
  }
}

function fastest(trials: readonly BackendTrial[]): BackendTrial | undefined {
  return trials
    .filter(({ outcome }) => outcome === 'slower')
    .reduce<BackendTrial | undefined>(
      (best, trial) => (best === undefined || trial.probeMs! < best.probeMs! ? trial : best),
      undefined,
    );
}
