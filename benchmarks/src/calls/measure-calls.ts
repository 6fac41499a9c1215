import { mainThreadCpuUs } from '../cpu-time.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions } from '../measuring/workload.ts';
import { CallSeries, type Callee } from './call-series.ts';

/** Code that was called for so long is compiled as well as it will be. */
const FIRST_CALLS_MS = 1500;

/** Calls before anything is measured, once after a start: programs that run for hours are what counts. */
export async function warmUp<Prepared, Answer>(callee: Callee<Prepared, Answer>): Promise<void> {
  const series = new CallSeries(callee);
  await series.run(FIRST_CALLS_MS);
  const [fault] = series.result().faults;
  if (fault !== undefined) throw new Error(`Before anything was measured, ${fault}.`);
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
  const series = new CallSeries(callee);
  await series.run(warmUpMs);
  const stopLap = startLap(pids);
  const startCpuUs = mainThreadCpuUs();
  await series.run(measureMs);
  const callingCpuUs = mainThreadCpuUs() - startCpuUs;
  const lap = stopLap();
  const { p50Us, p99Us, count, faults } = series.result();
  return {
    figures: {
      p50Us,
      p99Us,
      callingCpuUs: callingCpuUs / count,
      ownCpuUs: lap.ownCpuUs / count,
      ...(pids.length > 0 && { cpuUs: lap.cpuUs / count }),
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: count,
    faults,
  };
}
