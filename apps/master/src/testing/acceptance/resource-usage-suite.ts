import { describe, expect, it } from 'vitest';
import type { ResourceUsage } from '../../core/ports/resource-usage.ts';

/** Acceptance tests of resource measurement. */
export function resourceUsageSuite(name: string, createUsage: () => ResourceUsage): void {
  describe(`${name}, a ResourceUsage`, () => {
    it('tells plausible numbers, call after call', () => {
      const usage = createUsage();
      expect(usage.processors).toBeGreaterThanOrEqual(1);
      for (let i = 0; i < 3; i++) {
        const { cpuPercent, busyPercent, delayMs } = usage.measure();
        for (const value of [cpuPercent, busyPercent, delayMs]) {
          expect(Number.isFinite(value)).toBe(true);
          expect(value).toBeGreaterThanOrEqual(0);
        }
        expect(busyPercent).toBeLessThanOrEqual(100.01);
        expect(usage.memoryBytes()).toBeGreaterThan(1024 * 1024);
      }
    });
  });
}
