import type { Init, Session } from '@ubii/proto';
import { clickCounterSession } from './click-counter-session.ts';
import { gatherPointersSession } from './gather-pointers-session.ts';
import { hysteresisSession } from './hysteresis-session.ts';
import { keyChordSession } from './key-chord-session.ts';
import { manyPointersSession } from './many-pointers-session.ts';
import { metronomeSession } from './metronome-session.ts';
import { mirrorPointerSession } from './mirror-pointer-session.ts';
import { mixedWavesSession } from './mixed-waves-session.ts';
import { movingAverageSession } from './moving-average-session.ts';
import { pictureEdgesSession } from './picture-edges-session.ts';
import { pointerColorSession } from './pointer-color-session.ts';
import { pointerSpeedSession } from './pointer-speed-session.ts';
import { sineWaveSession } from './sine-wave-session.ts';
import { smoothPointerSession } from './smooth-pointer-session.ts';
import { smoothingChainSession } from './smoothing-chain-session.ts';
import { touchProximitySession } from './touch-proximity-session.ts';

/**
 * Example sessions by id; the name of each is its title. They only name their modules; the master adds the definitions. [SE-1]
 * `sessions/<id>.session` has the same session as JSON.
 */
export const EXAMPLE_SESSIONS: {
  readonly 'sine-wave': Init<Session>;
  readonly 'mixed-waves': Init<Session>;
  readonly 'smooth-pointer': Init<Session>;
  readonly 'mirror-pointer': Init<Session>;
  readonly 'pointer-speed': Init<Session>;
  readonly 'pointer-color': Init<Session>;
  readonly 'click-counter': Init<Session>;
  readonly metronome: Init<Session>;
  readonly 'many-pointers': Init<Session>;
  readonly hysteresis: Init<Session>;
  readonly 'moving-average': Init<Session>;
  readonly 'picture-edges': Init<Session>;
  readonly 'key-chord': Init<Session>;
  readonly 'smoothing-chain': Init<Session>;
  readonly 'gather-pointers': Init<Session>;
  readonly 'touch-proximity': Init<Session>;
} = {
  'sine-wave': sineWaveSession,
  'mixed-waves': mixedWavesSession,
  'smooth-pointer': smoothPointerSession,
  'mirror-pointer': mirrorPointerSession,
  'pointer-speed': pointerSpeedSession,
  'pointer-color': pointerColorSession,
  'click-counter': clickCounterSession,
  metronome: metronomeSession,
  'many-pointers': manyPointersSession,
  hysteresis: hysteresisSession,
  'moving-average': movingAverageSession,
  'picture-edges': pictureEdgesSession,
  'key-chord': keyChordSession,
  'smoothing-chain': smoothingChainSession,
  'gather-pointers': gatherPointersSession,
  'touch-proximity': touchProximitySession,
};
