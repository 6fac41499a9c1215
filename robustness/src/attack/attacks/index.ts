import type { Attack } from '../attack.ts';
import { amplification } from './amplification.ts';
import { awayClients } from './away.ts';
import { clusterSecrets } from './cluster.ts';
import { connections, descriptors } from './connections.ts';
import { frames } from './frames.ts';
import { guests } from './guests.ts';
import { deletedIds, fileModes, flightSilence } from './kept-data.ts';
import { largeBodies, slowHeads, unfinishedBodies } from './requests.ts';
import { longNames } from './long-names.ts';
import { moduleMemory, runawayDemuxer } from './modules.ts';
import { localName, localUsers, originNull, proxies } from './pretenders.ts';
import { ghostInputs, replayRights, studyCodes } from './replays.ts';
import { revoking, wrongCodes } from './credentials.ts';
import { shares } from './shares.ts';
import {
  uploadClaims,
  uploadLengths,
  uploadsAtOnce,
  uploadTexts,
  uploadWeight,
} from './uploads.ts';

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
  frames,
  uploadLengths,
  uploadWeight,
  uploadTexts,
  uploadClaims,
  uploadsAtOnce,
  guests,
  replayRights,
  studyCodes,
  ghostInputs,
  fileModes,
  flightSilence,
  deletedIds,
  awayClients,
  clusterSecrets,
];
