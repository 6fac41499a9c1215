import type { ComponentInit } from '@ubii/client-web';
import { componentTopic, type Init, type Session } from '@ubii/proto';
import { exampleTopic, POINTER_COMPONENT } from '../../devices/pointer-topic.ts';

/** The device of the pad on Home. */
export const PAD_DEVICE = 'demo';
export const PAD_COMPONENTS = [
  {
    name: 'pointer',
    format: 'vector2',
    tags: ['pointer'],
    description: 'Pointer on the pad of Home, 0 to 1 on both axes, origin top left.',
  },
] as const satisfies readonly ComponentInit[];

const MODULE = 'mirror-pointer';
/** Tag of sessions that were begun from Home. A second tag is the id of the client. */
const TAG = 'first-session';

/** Topics of the session on Home: what it reads, and what it writes. */
export const padTopics = (clientId: string) => ({
  pointer: componentTopic(clientId, PAD_DEVICE, 'pointer'),
  mirrored: componentTopic(clientId, PAD_DEVICE, 'mirrored'),
});

function mirror(topics: { readonly pointer: string; readonly mirrored: string }) {
  return {
    processingModules: [{ name: MODULE }],
    ioMappings: [
      {
        processingModuleName: MODULE,
        inputMappings: [
          { inputName: 'pointer', topic: topics.pointer },
          { inputName: 'mirrorX', constantJson: JSON.stringify({ bool: true }) },
        ],
        outputMappings: [{ outputName: 'mirrored', topic: topics.mirrored }],
      },
    ],
  } satisfies Init<Session>;
}

/** The session that runs while Home is open: one module, which mirrors the pointer on the pad. */
export function padSession(clientId: string, clientName: string): Init<Session> {
  return {
    name: `Home of ${clientName}`,
    description: 'Mirrors the pointer on the page Home. Ends when the page is left.',
    tags: ['example'],
    authors: [clientName],
    ...mirror(padTopics(clientId)),
  };
}

/** True for the session that this client runs while Home is open. */
export function isPadSession(
  { ioMappings }: Pick<Session, 'ioMappings'>,
  clientId: string,
): boolean {
  const { pointer } = padTopics(clientId);
  return ioMappings.some(({ inputMappings }) => inputMappings.some((one) => one.topic === pointer));
}

/** The same session to keep and to change: it reads the pointer of this browser on every page. */
export function ownSession(clientId: string): Init<Session> {
  return {
    name: 'Mirror my pointer',
    description: 'Mirrors the pointer of a browser. Replace its module, and see what follows.',
    tags: ['example', TAG, clientId],
    // Not stored: it ends with the master.
    extension: { startWithMaster: false },
    ...mirror({
      pointer: exampleTopic(clientId, POINTER_COMPONENT),
      mirrored: componentTopic(clientId, PAD_DEVICE, 'mirrored'),
    }),
  };
}

/** True for a session that this client keeps. */
export const isOwnSession = ({ tags }: Pick<Session, 'tags'>, clientId: string): boolean =>
  tags.includes(TAG) && tags.includes(clientId);
