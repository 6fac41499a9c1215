import type { ResourceUsage } from '../core/ports/resource-usage.ts';

/** A process that always takes the same. */
export class FixedUsage implements ResourceUsage {
  cpuPercent(): number {
    return 12.5;
  }

  memoryBytes(): number {
    return 80 * 1024 * 1024;
  }
}
