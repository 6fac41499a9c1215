import type { Init, Session } from '@ubii/proto';
import { isAlive } from '../../sessions/state/session-state.ts';
import type { GalleryEntry } from './gallery.ts';
import { inputTopic } from './inputs/page-device.ts';

const tagOf = ({ id }: Pick<GalleryEntry, 'id'>): string => `example:${id}`;

/** The session of an example as it is sent: named for people, recognised later, on inputs of a client. */
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
    name: entry.title,
    description: entry.sentence,
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

/** The session of an example that counts, of all there are: what runs before what rests. */
export function sessionOfEntry(
  entry: Pick<GalleryEntry, 'id'>,
  sessions: readonly Session[],
): Session | undefined {
  return sessions
    .filter(({ tags }) => tags.includes(tagOf(entry)))
    .sort((a, b) => Number(isAlive(b)) - Number(isAlive(a)) || (a.id < b.id ? -1 : 1))[0];
}

/** The client whose page a session takes its inputs from; undefined when it takes none by topic. */
export function inputClient(entry: GalleryEntry, session: Session): string | undefined {
  for (const { inputMappings } of session.ioMappings) {
    for (const { topic } of inputMappings) {
      const clientId = topic?.split('/')[1] ?? '';
      if (entry.inputs.some(({ input }) => topic === inputTopic(clientId, input))) return clientId;
    }
  }
  return undefined;
}

/** The session with the inputs of another client in place of those it has. */
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
