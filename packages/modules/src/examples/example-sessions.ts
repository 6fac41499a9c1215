import type { Init, Session } from '@ubii/proto';
import { mirrorPointerSession } from './mirror-pointer-session.ts';
import { smoothingChainSession } from './smoothing-chain-session.ts';
import { touchProximitySession } from './touch-proximity-session.ts';

/**
 * Sessions of modules of this library, by name. They name their modules only: a master fills in the
 * rest. [SE-1] `sessions/<name>.session` is the same as JSON.
 */
export const EXAMPLE_SESSIONS: {
  readonly 'mirror-pointer': Init<Session>;
  readonly 'smoothing-chain': Init<Session>;
  readonly 'touch-proximity': Init<Session>;
} = {
  'mirror-pointer': mirrorPointerSession,
  'smoothing-chain': smoothingChainSession,
  'touch-proximity': touchProximitySession,
};
