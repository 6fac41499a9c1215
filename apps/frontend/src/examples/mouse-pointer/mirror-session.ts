import type { Init, ProcessingModule, Session } from '@ubii/proto';
import {
  exampleTopic,
  MIRROR_X_COMPONENT,
  MIRROR_Y_COMPONENT,
  MIRRORED_COMPONENT,
  POINTER_COMPONENT,
} from './pointer-topic.ts';

/** Marks the sessions of this example, together with the id of the client each belongs to. */
const TAG = 'mouse-pointer';

/** Who sends the session, and where its module is to run. */
export interface MirrorSessionFacts {
  readonly clientId: string;
  readonly clientName: string;
  /** Source and all: the master need not have it. */
  readonly module: Init<ProcessingModule>;
  readonly nodeId: string;
}

/**
 * The whole runtime context of the example, made by the client: one module, and what flows where. It
 * takes the pointer and two switches, and puts the pointer out mirrored.
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
    description: 'Mirrors the pointer of the mouse-pointer example. It ends when its page is left.',
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

/** True for a session that an earlier run of this page has left behind. */
export function isMirrorSessionOf({ tags }: Pick<Session, 'tags'>, clientId: string): boolean {
  return tags.includes(TAG) && tags.includes(clientId);
}

/** The session with its module on another node. [SE-15] */
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
