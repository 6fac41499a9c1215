import type { ResourceUsage } from '../../core/ports/index.ts';

/** What this process takes from the machine. */
export class ProcessUsage implements ResourceUsage {
  #earlier: { readonly cpuMicroseconds: number; readonly atMs: number } | undefined;

  cpuPercent(): number {
    const { user, system } = process.cpuUsage();
    const now = { cpuMicroseconds: user + system, atMs: performance.now() };
    const earlier = this.#earlier;
    this.#earlier = now;
    if (earlier === undefined || now.atMs <= earlier.atMs) return 0;
    return (now.cpuMicroseconds - earlier.cpuMicroseconds) / (now.atMs - earlier.atMs) / 10;
  }

  memoryBytes(): number {
    return process.memoryUsage.rss();
  }
}
