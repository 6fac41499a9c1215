import { MuxIdentity, type TopicMux } from '@ubii/proto';

/** What tells a topic of a muxer apart, where its name says so; else undefined. [PM-43] */
export function identityIn(mux: TopicMux, topic: string): string | undefined {
  const { identitySource, identityMatchPattern } = mux;
  if (identitySource !== MuxIdentity.MUX_IDENTITY_PATTERN || identityMatchPattern === '') {
    return undefined;
  }
  try {
    const match = new RegExp(identityMatchPattern).exec(topic);
    return match?.[1] ?? match?.[0] ?? undefined;
  } catch {
    return undefined;
  }
}
