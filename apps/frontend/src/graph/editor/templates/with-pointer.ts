import type { Session } from '@ubii/proto';

/** Replaces the pointer topic of a session. */
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
