import { machineCpuUs, processCpuUs } from '../cpu-time.ts';

/** Time and CPU time used between `start` and `stop`. */
export interface Lap {
  readonly wallUs: number;
  /** CPU time of the broker's process, µs. */
  readonly brokerCpuUs: number;
  /** CPU time of this process, the load generator, as a share of the time: 1 is a whole core. */
  readonly loadCpuShare: number;
  /** CPU time of everything else on the machine, in the same unit. */
  readonly otherCpuShare: number;
}

/** Starts the clocks; the returned function stops them. */
export function startLap(brokerPid: number): () => Lap {
  const ownCpu = process.cpuUsage();
  const brokerStartUs = processCpuUs(brokerPid);
  const machineStartUs = machineCpuUs();
  const startMs = performance.now();
  return () => {
    const wallUs = (performance.now() - startMs) * 1000;
    const used = process.cpuUsage(ownCpu);
    const loadCpuUs = used.user + used.system;
    const brokerCpuUs = processCpuUs(brokerPid) - brokerStartUs;
    const otherCpuUs = machineCpuUs() - machineStartUs - brokerCpuUs - loadCpuUs;
    return {
      wallUs,
      brokerCpuUs,
      loadCpuShare: loadCpuUs / wallUs,
      otherCpuShare: Math.max(0, otherCpuUs / wallUs),
    };
  };
}
