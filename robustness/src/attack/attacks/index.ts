import type { Attack } from '../attack.ts';
import { amplification } from './amplification.ts';
import { connections } from './connections.ts';
import { descriptors } from './descriptors.ts';
import { largeBodies } from './large-bodies.ts';
import { longNames } from './long-names.ts';
import { moduleMemory } from './module-memory.ts';
import { localName, localUsers, originNull, proxies } from './pretenders.ts';
import { revoking } from './revoking.ts';
import { runawayDemuxer } from './runaway-demuxer.ts';
import { shares } from './shares.ts';
import { slowHeads } from './slow-heads.ts';
import { unfinishedBodies } from './unfinished-bodies.ts';
import { wrongCodes } from './wrong-codes.ts';

/** Every attack, in the order of the report. */
export const ATTACKS: readonly Attack[] = [
  descriptors,
  largeBodies,
  unfinishedBodies,
  connections,
  runawayDemuxer,
  originNull,
  proxies,
  longNames,
  shares,
  revoking,
  amplification,
  moduleMemory,
  wrongCodes,
  localName,
  localUsers,
  slowHeads,
];
