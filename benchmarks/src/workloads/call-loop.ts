import { mainThreadCpuUs } from '../cpu-time.ts';
import { percentile } from '../statistics.ts';
import { startLap } from './stopwatch.ts';
import type { Measurement, MeasureOptions } from './workload.ts';

/** Room for the samples of the fastest calls and the longest run. */
const MAX_SAMPLES = 1_000_000;
/** No answer for so long: it is lost. */
const STALL_MS = 2_000;

/** One thing that can be called, again and again. */
export interface Callee<Prepared, Answer> {
  /** Number of the last call; goes on from one measurement to the next. */
  sequence: number;
  /** Makes what call number `sequence` needs; not measured. */
  prepare(sequence: number): Prepared;
  call(prepared: Prepared): Promise<Answer>;
  isRight(answer: Answer, sequence: number): boolean;
  /** Lets the call under way reject, where it may be lost. */
  abandon?(reason: Error): void;
  /** What else went wrong since the last look, one sentence each. */
  takeFaults?(): string[];
}

/**
 * Calls, waits for the answer, checks it, calls again.
 *
 * @param pids of the processes that do the work; none: this one does
 */
export async function measureCalls<Prepared, Answer>(
  callee: Callee<Prepared, Answer>,
  { warmUpMs, measureMs }: MeasureOptions,
  pids: readonly number[] = [],
): Promise<Measurement> {
  const firstCall = callee.sequence;
  const samples = new Float64Array(MAX_SAMPLES);
  let count = 0;
  let wrong = 0;
  const callOnce = async (): Promise<void> => {
    callee.sequence += 1;
    const { sequence } = callee;
    const prepared = callee.prepare(sequence);
    const startMs = performance.now();
    const answer = await callee.call(prepared);
    const tookMs = performance.now() - startMs;
    if (!callee.isRight(answer, sequence)) wrong += 1;
    if (count === MAX_SAMPLES) return;
    samples[count] = tookMs * 1000;
    count += 1;
  };

  const callFor = async (durationMs: number): Promise<void> => {
    const untilMs = performance.now() + durationMs;
    while (performance.now() < untilMs) await callOnce();
  };
  const stopWatching = watch(
    () => callee.sequence,
    () => callee.abandon?.(new Error(`there was no answer within ${STALL_MS / 1000} s`)),
  );
  const faults: string[] = [];
  let stopLap = startLap(pids);
  let startCpuUs = mainThreadCpuUs();
  try {
    await callFor(warmUpMs);
    count = 0;
    stopLap = startLap(pids);
    startCpuUs = mainThreadCpuUs();
    await callFor(measureMs);
  } catch (error) {
    faults.push(`call ${callee.sequence} failed: ${messageOf(error)}`);
  }
  const callingCpuUs = mainThreadCpuUs() - startCpuUs;
  const lap = stopLap();
  stopWatching();
  if (wrong > 0) faults.push(`${wrong} of ${callee.sequence - firstCall} answers were wrong`);
  faults.push(...(callee.takeFaults?.() ?? []));

  const sorted = samples.subarray(0, count).sort();
  return {
    figures: {
      p50Us: percentile(sorted, 0.5),
      p99Us: percentile(sorted, 0.99),
      callingCpuUs: callingCpuUs / count,
      ownCpuUs: lap.ownCpuUs / count,
      ...(pids.length > 0 && { cpuUs: lap.cpuUs / count }),
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: count,
    faults,
  };
}

/** Calls `onStall` when `progress` says the same for too long. */
function watch(progress: () => number, onStall: () => void): () => void {
  let before = progress();
  const timer = setInterval(() => {
    const now = progress();
    if (now === before) onStall();
    before = now;
  }, STALL_MS);
  return () => clearInterval(timer);
}

/** Faults of modules are values, not errors. */
function messageOf(thrown: unknown): string {
  const isObject = typeof thrown === 'object' && thrown !== null;
  return isObject && 'message' in thrown ? String(thrown.message) : String(thrown);
}
