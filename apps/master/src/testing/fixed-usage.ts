import type { ResourceUsage, UsageMeasurement } from '../core/ports/resource-usage.ts';

/** A process that takes what the test says; always the same. */
export class FixedUsage implements ResourceUsage {
  readonly processors = 4;
  measured: UsageMeasurement = { cpuPercent: 12.5, busyPercent: 5, delayMs: 1 };

  measure(): UsageMeasurement {
    return this.measured;
  }

  memoryBytes(): number {
    return 80 * 1024 * 1024;
  }
}
