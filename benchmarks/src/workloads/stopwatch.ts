import { processCpuUs } from '../process-cpu.ts';

/** Time and CPU time used between `start` and `stop`. */
export interface Lap {
  readonly wallUs: number;
  /** CPU time of the broker's process, µs. */
  readonly brokerCpuUs: number;
  /** CPU time of this process, the load generator, as a share of the time: 1 is a whole core. */
  readonly loadCpuShare: number;
}

/** Starts the clocks; the returned function stops them. */
export function startLap(brokerPid: number): () => Lap {
  const ownCpu = process.cpuUsage();
  const brokerCpuUs = processCpuUs(brokerPid);
  const startMs = performance.now();
  return () => {
    const wallUs = (performance.now() - startMs) * 1000;
    const used = process.cpuUsage(ownCpu);
    return {
      wallUs,
      brokerCpuUs: processCpuUs(brokerPid) - brokerCpuUs,
      loadCpuShare: (used.user + used.system) / wallUs,
    };
  };
}
