import type { StatusSample } from '@ubii/proto';
import { formatNumber } from '../ui/readouts/format-number.ts';
import { formatMilliseconds } from '../ui/readouts/format-time.ts';
import type { Readout } from '../ui/readouts/readout.ts';

export type LoadName = 'busy' | 'cpu' | 'delay';

/** How one load of the master is shown. */
export interface LoadInfo {
  readonly title: string;
  /** @param processors number of cores of the master's machine */
  valueOf(sample: StatusSample, processors: number): number;
  format(value: number): Readout;
  /** Value from which clients notice it. */
  readonly high: number;
}

/** Load from which clients notice it, percent. */
const BUSY_PERCENT = 80;
const SLOW_MS = 50;

const percent = (value: number): Readout => ({ digits: formatNumber(value), unit: '%' });

export const LOAD_CHARTS: Readonly<Record<LoadName, LoadInfo>> = {
  busy: {
    title: 'Main-thread load',
    valueOf: ({ busyPercent }) => busyPercent,
    format: percent,
    high: BUSY_PERCENT,
  },
  cpu: {
    title: 'CPU load of the master',
    valueOf: ({ cpuPercent }, processors) => cpuPercent / Math.max(1, processors),
    format: percent,
    high: BUSY_PERCENT,
  },
  delay: {
    title: 'Event-loop delay',
    valueOf: ({ delayMs }) => delayMs,
    format: formatMilliseconds,
    high: SLOW_MS,
  },
};

/** The one chart that explains problems of the master: what came in, or what was used up. */
export function chartThatExplains(codes: readonly string[]): LoadName | 'records' | undefined {
  if (codes.includes('master_busy')) return 'busy';
  if (codes.includes('machine_busy')) return 'cpu';
  return codes.includes('publisher_noisy') ? 'records' : undefined;
}
