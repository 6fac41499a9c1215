import type { Init, Session } from '@ubii/proto';

import {
  gatherPointersSession,
  manyPointersSession,
  touchProximitySession,
} from './many-pointers-sessions.ts';
import {
  clickCounterSession,
  mirrorPointerSession,
  smoothPointerSession,
  pointerSpeedSession,
  pointerColorSession,
  keyChordSession,
} from './pointer-sessions.ts';
import {
  hysteresisSession,
  mixedWavesSession,
  sineWaveSession,
  movingAverageSession,
  smoothingChainSession,
  metronomeSession,
} from './signal-sessions.ts';

/** Images are records as all values: one module generates images, another one detects their edges. */
const pictureEdgesSession = {
  name: 'Edges of a picture',
  description: 'Generates a picture, converts it to greyscale, and detects its edges.',
  tags: ['example'],
  processingModules: [{ name: 'test-picture' }, { name: 'picture-edges' }],
  ioMappings: [
    {
      processingModuleName: 'test-picture',
      outputMappings: [{ outputName: 'picture', topic: '/examples/picture-edges/picture' }],
    },
    {
      processingModuleName: 'picture-edges',
      inputMappings: [{ inputName: 'picture', topic: '/examples/picture-edges/picture' }],
      outputMappings: [
        { outputName: 'grey', topic: '/examples/picture-edges/grey' },
        { outputName: 'edges', topic: '/examples/picture-edges/edges' },
      ],
    },
  ],
} satisfies Init<Session>;

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
