import type { Session } from '@ubii/proto';

/** The session with another topic where it takes a pointer. */
export function withPointer(session: Session, from: string | undefined, to: string): Session {
  if (from === undefined) return session;
  return {
    ...session,
    ioMappings: session.ioMappings.map((mapping) => ({
      ...mapping,
      inputMappings: mapping.inputMappings.map((input) =>
        input.topic === from ? { ...input, topic: to } : input,
      ),
    })),
  };
}
