import type { Init, Session } from '@ubii/proto';
import { smoothedTopic } from './viewer-topics.ts';

/** Marks the sessions of this example, together with the id of the client each smooths. */
const TAG = 'model-viewer-smoothing';

/** One module between a phone and those who look: the one-euro filter, which knows that q and -q are one turn. */
export function smoothingSession(clientId: string, name: string, topic: string): Init<Session> {
  const module = 'one-euro-filter-quaternion';
  return {
    name: `Smooth turn of ${name}`,
    description: 'Smooths how a phone is turned, for the model viewer.',
    tags: ['example', TAG, clientId],
    processingModules: [{ name: module }],
    ioMappings: [
      {
        processingModuleName: module,
        inputMappings: [
          { inputName: 'value', topic },
          // Calm while it is held, within some 20 ms while it is turned fast.
          { inputName: 'minCutoffHz', constantJson: '{"double":1.5}' },
          { inputName: 'beta', constantJson: '{"double":8}' },
        ],
        outputMappings: [{ outputName: 'smoothed', topic: smoothedTopic(clientId) }],
      },
    ],
  };
}

/** True for the session that smooths this client. */
export function isSmoothingOf({ tags }: Pick<Session, 'tags'>, clientId: string): boolean {
  return tags.includes(TAG) && tags.includes(clientId);
}
