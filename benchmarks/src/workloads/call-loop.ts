import { mainThreadCpuUs } from '../cpu-time.ts';
import { percentile } from '../statistics.ts';
import { startLap } from './stopwatch.ts';
import type { Measurement, MeasureOptions } from './workload.ts';

/** Room for the samples of the fastest calls and the longest run. */
const MAX_SAMPLES = 1_000_000;

/** One thing that can be called, again and again. */
export interface Callee<Prepared, Answer> {
  /** Makes what call number `sequence` needs; not measured. */
  prepare(sequence: number): Prepared;
  call(prepared: Prepared): Promise<Answer>;
  isRight(answer: Answer, sequence: number): boolean;
}

/** Calls, waits for the answer, checks it, calls again. */
export async function measureCalls<Prepared, Answer>(
  callee: Callee<Prepared, Answer>,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const samples = new Float64Array(MAX_SAMPLES);
  let count = 0;
  let sequence = 0;
  let wrong = 0;
  const callOnce = async (): Promise<void> => {
    sequence += 1;
    const prepared = callee.prepare(sequence);
    const startMs = performance.now();
    const answer = await callee.call(prepared);
    const tookMs = performance.now() - startMs;
    if (!callee.isRight(answer, sequence)) wrong += 1;
    if (count === MAX_SAMPLES) return;
    samples[count] = tookMs * 1000;
    count += 1;
  };

  const warmUntilMs = performance.now() + warmUpMs;
  while (performance.now() < warmUntilMs) await callOnce();
  count = 0;
  const stopLap = startLap([]);
  const startCpuUs = mainThreadCpuUs();
  const untilMs = performance.now() + measureMs;
  while (performance.now() < untilMs) await callOnce();
  const callingCpuUs = mainThreadCpuUs() - startCpuUs;
  const lap = stopLap();

  const sorted = samples.subarray(0, count).sort();
  return {
    figures: {
      p50Us: percentile(sorted, 0.5),
      p99Us: percentile(sorted, 0.99),
      callingCpuUs: callingCpuUs / count,
      cpuUs: lap.ownCpuUs / count,
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: count,
    faults: wrong > 0 ? [`${wrong} of ${sequence} answers were wrong`] : [],
  };
}
