import type { Init, Recording, ReplayStartRequest } from '@ubii/proto';
import type { Span } from '../timeline/span.ts';

/** A master plays at most so many copies of one ghost. [RP-3] */
const MAX_COPIES = 32;
const MAX_JITTER_MS = 60_000;

/** The span that a ghost plays. */
export interface GhostTarget {
  readonly span: Span;
  /** At the master; undefined for a file of this device. */
  readonly recording: Recording | undefined;
}

/** How a ghost plays, as typed. */
export interface GhostChoice {
  readonly name: string;
  readonly copies: string;
  readonly jitterMs: string;
}

export function copiesError({ copies }: Pick<GhostChoice, 'copies'>): string | undefined {
  const count = Number(copies);
  const isFine = Number.isInteger(count) && count >= 1 && count <= MAX_COPIES;
  return isFine ? undefined : `Enter a whole number from 1 to ${MAX_COPIES}.`;
}

export function jitterError({ jitterMs }: Pick<GhostChoice, 'jitterMs'>): string | undefined {
  const time = Number(jitterMs);
  const isFine = time >= 0 && time <= MAX_JITTER_MS;
  return isFine ? undefined : `Enter a time from 0 to ${MAX_JITTER_MS} ms.`;
}

/** The request that plays a span in a loop, as a client of its own for each copy. */
export function ghostRequest(
  { name, copies, jitterMs }: GhostChoice,
  recordingId: string,
  { fromMs, untilMs }: Span,
): Init<ReplayStartRequest> {
  return {
    recordingId,
    isGhost: true,
    isLooping: true,
    name: name.trim(),
    span: { fromMs, untilMs },
    copies: Number(copies),
    jitterMs: Number(jitterMs),
  };
}
