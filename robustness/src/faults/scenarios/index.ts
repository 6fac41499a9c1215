import type { Scenario } from '../fault-run.ts';
import { clockJumps } from './clock-jumps.ts';
import { fullDisk, readOnlyDisk } from './full-disk.ts';
import { killMaster, killNode } from './kill-processes.ts';
import { killTab } from './kill-tab.ts';
import { lossyNetwork } from './lossy-network.ts';
import { roughNetwork } from './rough-network.ts';

export const SCENARIOS: readonly Scenario[] = [
  killMaster,
  killNode,
  killTab,
  fullDisk,
  readOnlyDisk,
  clockJumps,
  lossyNetwork,
  roughNetwork,
];
