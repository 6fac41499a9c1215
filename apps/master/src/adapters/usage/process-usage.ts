import { availableParallelism } from 'node:os';
import { monitorEventLoopDelay, performance, type EventLoopUtilization } from 'node:perf_hooks';

import type { ResourceUsage, UsageMeasurement } from '../../core/ports/index.ts';

/** Resolution of the histogram of the event-loop delay, milliseconds. An idle process wakes once for each. */
const DELAY_RESOLUTION_MS = 50;

interface Moment {
  readonly cpuMicroseconds: number;
  readonly atMs: number;
  readonly loop: EventLoopUtilization;
}

/** Resource usage of this process. */
export class ProcessUsage implements ResourceUsage {
  readonly processors = availableParallelism();
  readonly #delay = monitorEventLoopDelay({ resolution: DELAY_RESOLUTION_MS });
  #earlier: Moment | undefined;

  measure(): UsageMeasurement {
    const { user, system } = process.cpuUsage();
    const now = {
      cpuMicroseconds: user + system,
      atMs: performance.now(),
      loop: performance.eventLoopUtilization(),
    };
    const earlier = this.#earlier;
    this.#earlier = now;
    if (earlier === undefined || now.atMs <= earlier.atMs) {
      this.#delay.enable();
      return { cpuPercent: 0, busyPercent: 0, delayMs: 0 };
    }
    // A timer that is on time is one resolution after the one before.
    const delayMs = this.#delay.percentile(99) / 1e6 - DELAY_RESOLUTION_MS;
    const hasLooked = this.#delay.count > 0;
    this.#delay.reset();
    return {
      cpuPercent: (now.cpuMicroseconds - earlier.cpuMicroseconds) / (now.atMs - earlier.atMs) / 10,
      busyPercent: performance.eventLoopUtilization(now.loop, earlier.loop).utilization * 100,
      delayMs: hasLooked ? Math.max(0, delayMs) : 0,
    };
  }

  memoryBytes(): number {
    return process.memoryUsage.rss();
  }
}
