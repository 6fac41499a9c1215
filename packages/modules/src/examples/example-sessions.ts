import type { Init, Session } from '@ubii/proto';
import { gatherPointersSession } from './gather-pointers-session.ts';
import { mirrorPointerSession } from './mirror-pointer-session.ts';
import { smoothPointerSession } from './smooth-pointer-session.ts';
import { smoothingChainSession } from './smoothing-chain-session.ts';
import { touchProximitySession } from './touch-proximity-session.ts';

/**
 * Sessions of modules of this library, by name. They name their modules only: a master fills in the
 * rest. [SE-1] `sessions/<name>.session` is the same as JSON.
 */
export const EXAMPLE_SESSIONS: {
  readonly 'smooth-pointer': Init<Session>;
  readonly 'mirror-pointer': Init<Session>;
  readonly 'smoothing-chain': Init<Session>;
  readonly 'gather-pointers': Init<Session>;
  readonly 'touch-proximity': Init<Session>;
} = {
  'smooth-pointer': smoothPointerSession,
  'mirror-pointer': mirrorPointerSession,
  'smoothing-chain': smoothingChainSession,
  'gather-pointers': gatherPointersSession,
  'touch-proximity': touchProximitySession,
};
