import type { Init, Session } from '@ubii/proto';
import type { GalleryEntry } from './gallery.ts';
import { inputTopic } from './inputs/page-device.ts';

const tagOf = ({ id }: Pick<GalleryEntry, 'id'>): string => `example:${id}`;

/** Returns the session of an example with a tag to find it again and the inputs of a client. */
export function gallerySession(
  entry: GalleryEntry,
  spec: Init<Session>,
  clientId: string,
): Init<Session> {
  const topics = new Map(
    entry.inputs.map(({ topic, input }) => [topic, inputTopic(clientId, input)]),
  );
  return {
    ...spec,
    description: `${entry.sentence} ${entry.advice}`,
    tags: [...(spec.tags ?? []), tagOf(entry)],
    ioMappings: (spec.ioMappings ?? []).map((mapping) => ({
      ...mapping,
      inputMappings: (mapping.inputMappings ?? []).map((input) => {
        const topic = topics.get(input.topic ?? '');
        return topic === undefined ? input : { ...input, topic };
      }),
    })),
  };
}

/** True for the session of an example. */
export const isSessionOf = (
  entry: Pick<GalleryEntry, 'id'>,
  { tags }: Pick<Session, 'tags'>,
): boolean => tags.includes(tagOf(entry));

/** Returns the client whose page provides the inputs; undefined when the session has no such input. */
export function inputClient(entry: GalleryEntry, session: Session): string | undefined {
  for (const { inputMappings } of session.ioMappings) {
    for (const { topic } of inputMappings) {
      const clientId = topic?.split('/')[1] ?? '';
      if (entry.inputs.some(({ input }) => topic === inputTopic(clientId, input))) return clientId;
    }
  }
  return undefined;
}

/** Returns the mappings of the session with the inputs of another client. */
export function withInputsOf(
  entry: GalleryEntry,
  session: Session,
  clientId: string,
): Session['ioMappings'] {
  const before = inputClient(entry, session) ?? '';
  const topics = new Map(
    entry.inputs.map(({ input }) => [inputTopic(before, input), inputTopic(clientId, input)]),
  );
  return session.ioMappings.map((mapping) => ({
    ...mapping,
    inputMappings: mapping.inputMappings.map((input) => {
      const topic = topics.get(input.topic ?? '');
      return topic === undefined ? input : { ...input, topic };
    }),
  }));
}
