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

/** The client of the session, and the node of its module. */
export interface MirrorSessionFacts {
  readonly clientId: string;
  readonly clientName: string;
  /** With its source, so that the master does not need to have it. */
  readonly module: Init<ProcessingModule>;
  readonly nodeId: string;
}

/**
 * Returns the session of the example: one module and its mappings. Its inputs are the pointer and two
 * switches, its output is the mirrored pointer.
 */
export function mirrorSession({
  clientId,
  clientName,
  module,
  nodeId,
}: MirrorSessionFacts): Init<Session> {
  const topic = (component: string): string => exampleTopic(clientId, component);
  return {
    name: `Mouse pointer of ${clientName}`,
    description: 'Mirrors the pointer of the Mouse pointer example. Ends when the page is closed.',
    tags: ['example', TAG, clientId],
    authors: [clientName],
    processingModules: [{ ...module, nodeId }],
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

/** Returns the session with its module on another node. [SE-15] */
export function onNode(session: Session, nodeId: string): Init<Session> {
  return {
    ...session,
    processingModules: session.processingModules.map((module) => ({
      ...module,
      nodeId,
      extension: { ...module.extension, replaceable: false },
    })),
  };
}
