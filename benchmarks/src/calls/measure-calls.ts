import { mainThreadCpuUs } from '../cpu-time.ts';
import { startLap } from '../workloads/stopwatch.ts';
import type { Measurement, MeasureOptions } from '../workloads/workload.ts';
import { CallSeries, type Callee } from './call-series.ts';

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
