import type { Init, Session } from '@ubii/proto';
import { smoothedTopic } from './viewer-topics.ts';

/** Tag of the sessions of this example. A second tag is the id of the client. */
const TAG = 'model-viewer-smoothing';

/** Returns a session with one module: the 1€ filter for quaternions. */
export function smoothingSession(clientId: string, name: string, topic: string): Init<Session> {
  const module = 'one-euro-filter-quaternion';
  return {
    name: `Smooth rotation of ${name}`,
    description: 'Smooths the orientation of a phone for the model viewer.',
    tags: ['example', TAG, clientId],
    processingModules: [{ name: module }],
    ioMappings: [
      {
        processingModuleName: module,
        inputMappings: [
          { inputName: 'value', topic },
          // Little jitter while the phone is held still, a delay of some 20 ms while it is rotated fast.
          { inputName: 'minCutoffHz', constantJson: '{"double":1.5}' },
          { inputName: 'beta', constantJson: '{"double":8}' },
        ],
        outputMappings: [{ outputName: 'smoothed', topic: smoothedTopic(clientId) }],
      },
    ],
  };
}

/** True for the session that smooths the rotation of this client. */
export function isSmoothingOf({ tags }: Pick<Session, 'tags'>, clientId: string): boolean {
  return tags.includes(TAG) && tags.includes(clientId);
}
