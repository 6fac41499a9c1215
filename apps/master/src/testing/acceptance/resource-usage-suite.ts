import { describe, expect, it } from 'vitest';
import type { ResourceUsage } from '../../core/ports/resource-usage.ts';

/** What every measure of resources does. */
export function resourceUsageSuite(name: string, createUsage: () => ResourceUsage): void {
  describe(`${name}, a ResourceUsage`, () => {
    it('tells plausible numbers, call after call', () => {
      const usage = createUsage();
      for (let i = 0; i < 3; i++) {
        const cpuPercent = usage.cpuPercent();
        expect(Number.isFinite(cpuPercent)).toBe(true);
        expect(cpuPercent).toBeGreaterThanOrEqual(0);
        expect(usage.memoryBytes()).toBeGreaterThan(1024 * 1024);
      }
    });
  });
}
