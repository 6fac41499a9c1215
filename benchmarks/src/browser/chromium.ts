import { existsSync, readFileSync } from 'node:fs';

import { chromium } from '@playwright/test';

import { descendantPids, processCpuUs } from '../cpu-time.ts';
import type { Workload } from '../measuring/workload.ts';

const SYSTEM_CHROMIUM = '/usr/bin/chromium';
/** Start flags of measured browsers. */
export const CHROMIUM_FLAGS = [
  // The browser's own sandbox does not start as root.
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
  ...(process.env['UBII_BENCH_GPU'] === '1' ? [] : ['--disable-gpu']),
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** The browser to measure in: `UBII_CHROMIUM`, the system's, or Playwright's; undefined: there is none. */
export function findChromium(): string | undefined {
  const found = [process.env['UBII_CHROMIUM'], SYSTEM_CHROMIUM, chromium.executablePath()];
  return found.find((path) => path !== undefined && path !== '' && existsSync(path));
}

/** Common settings of workloads that open a browser. */
export const IN_CHROMIUM: Pick<Workload, 'placement' | 'roundShare' | 'whyNot'> = {
  // The browser has many threads of its own.
  placement: 'anywhere',
  roundShare: 1 / 5,
  whyNot: () =>
    findChromium() === undefined
      ? 'there is no Chromium; install one, or name it in UBII_CHROMIUM'
      : undefined,
};

/** CPU time of a browser, milliseconds. */
interface BrowserCpu {
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
