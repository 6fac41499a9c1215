import { readFileSync } from 'node:fs';
import { descendantPids, processCpuUs } from '../cpu-time.ts';

/** CPU time of a browser, milliseconds. */
export interface BrowserCpu {
  /** The threads that run the scripts of pages, and lay out and paint them. */
  readonly mainMs: number;
  /** All else: compositing, turning paint into pixels, input, the network. */
  readonly otherMs: number;
}

/**
 * Starts counting what the browsers that this process started use; the returned function stops.
 * @param others processes it started besides
 */
export function startBrowserCpu(others: readonly number[]): () => BrowserCpu {
  const start = readBrowserCpu(others);
  return () => {
    const end = readBrowserCpu(others);
    return { mainMs: end.mainMs - start.mainMs, otherMs: end.otherMs - start.otherMs };
  };
}

function readBrowserCpu(others: readonly number[]): BrowserCpu {
  let mainMs = 0;
  let allMs = 0;
  for (const pid of descendantPids(process.pid)) {
    if (others.includes(pid)) continue;
    try {
      const command = readFileSync(`/proc/${pid}/cmdline`, 'latin1');
      allMs += processCpuUs(pid) / 1000;
      if (!command.includes('--type=renderer')) continue;
      const schedstat = readFileSync(`/proc/${pid}/task/${pid}/schedstat`, 'latin1');
      mainMs += Number(schedstat.split(' ', 1)[0]) / 1e6;
    } catch {
      // It ended meanwhile.
    }
  }
  return { mainMs, otherMs: allMs - mainMs };
}
