import type { Scenario } from '../scenario.ts';
import { clockJumps } from './clock-jumps.ts';
import { fullDisk, readOnlyDisk } from './full-disk.ts';
import { killMaster } from './kill-master.ts';
import { killNode } from './kill-node.ts';
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
