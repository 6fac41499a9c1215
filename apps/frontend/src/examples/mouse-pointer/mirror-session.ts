import type { Init, ProcessingModule, Session } from '@ubii/proto';
import {
  exampleTopic,
  MIRROR_X_COMPONENT,
  MIRROR_Y_COMPONENT,
  MIRRORED_COMPONENT,
  POINTER_COMPONENT,
} from '../../devices/pointer-topic.ts';

/** Tag of the sessions of this example. A second tag is the id of the client. */
const TAG = 'mouse-pointer';

/** The module with its source, so that the master does not need to have it. */
export type MirrorModule = Init<ProcessingModule>;

/** The client of the session, and its module. */
export interface MirrorSessionFacts {
  readonly clientId: string;
  readonly clientName: string;
  readonly module: MirrorModule;
}

/**
 * Returns the session of the example: one module and its mappings. Its inputs are the pointer and two
 * switches, its output is the mirrored pointer.
 */
export function mirrorSession({ clientId, clientName, module }: MirrorSessionFacts): Init<Session> {
  const topic = (component: string): string => exampleTopic(clientId, component);
  return {
    name: `Mouse pointer of ${clientName}`,
    description: 'Mirrors the pointer of the Mouse pointer example. Ends when the page is closed.',
    tags: ['example', TAG, clientId],
    authors: [clientName],
    processingModules: [module],
    ioMappings: [
      {
        processingModuleName: module.name ?? '',
        inputMappings: [
          { inputName: 'pointer', topic: topic(POINTER_COMPONENT) },
          { inputName: 'mirrorX', topic: topic(MIRROR_X_COMPONENT) },
          { inputName: 'mirrorY', topic: topic(MIRROR_Y_COMPONENT) },
        ],
        outputMappings: [{ outputName: 'mirrored', topic: topic(MIRRORED_COMPONENT) }],
      },
    ],
  };
}

/** True for a session of this page, also from before a reload. */
export function isMirrorSessionOf({ tags }: Pick<Session, 'tags'>, clientId: string): boolean {
  return tags.includes(TAG) && tags.includes(clientId);
}
