import { findChromium } from './chromium.ts';
import type { Workload } from '../measuring/workload.ts';

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
