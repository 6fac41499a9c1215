import { machineCpuUs, processCpuUs } from '../cpu-time.ts';

/** Time and CPU time used between `start` and `stop`. */
export interface Lap {
  readonly wallUs: number;
  /** CPU time of the measured processes together, µs; of none when everything is in this process. */
  readonly cpuUs: number;
  /** CPU time of this process, all threads, µs. */
  readonly ownCpuUs: number;
  /** The same as a share of the time: 1 is a whole core. */
  readonly loadCpuShare: number;
  /** CPU time of everything else on the machine, in the same unit. */
  readonly otherCpuShare: number;
}

/**
 * Starts the clocks; the returned function stops them.
 *
 * @param measured processes, or a function that returns them: processes that start in between count completely
 */
export function startLap(measured: readonly number[] | (() => readonly number[])): () => Lap {
  const pidsNow = (): readonly number[] => (typeof measured === 'function' ? measured() : measured);
  const ownCpu = process.cpuUsage();
  const startUs = new Map(pidsNow().map((pid) => [pid, cpuUsOf(pid, 0)]));
  const machineStartUs = machineCpuUs();
  const startMs = performance.now();
  return () => {
    const wallUs = (performance.now() - startMs) * 1000;
    const used = process.cpuUsage(ownCpu);
    const ownCpuUs = used.user + used.system;
    const cpuUs = pidsNow().reduce((sum, pid) => {
      const beforeUs = startUs.get(pid) ?? 0;
      return sum + cpuUsOf(pid, beforeUs) - beforeUs;
    }, 0);
    const otherCpuUs = machineCpuUs() - machineStartUs - cpuUs - ownCpuUs;
    return {
      wallUs,
      cpuUs,
      ownCpuUs,
      loadCpuShare: ownCpuUs / wallUs,
      otherCpuShare: Math.max(0, otherCpuUs / wallUs),
    };
  };
}

/** Processes of browsers come and go; what one used that is over is not known any more. */
function cpuUsOf(pid: number, otherwiseUs: number): number {
  try {
    return processCpuUs(pid);
  } catch {
    return otherwiseUs;
  }
}
