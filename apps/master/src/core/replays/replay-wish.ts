import {
  ReplayConflict,
  ServiceError,
  type ReplaySpan,
  type ReplayStartRequest,
} from '@ubii/proto';
import type { Span } from '@ubii/recording';
import type { LimitWatch } from '../counters/limit-watch.ts';
import type { ReplayFacts } from '../ports/replay-files.ts';

const MIN_RATE = 0.1;
const MAX_RATE = 10;
const NS_PER_MS = 1e6;
const DEFAULT_LIVE_PREFIX = '/live';
/** Longest time over which the starts of copies are spread, milliseconds. */
const MAX_JITTER_MS = 3_600_000;

/** Rate, span and copies of a replay, checked. */
export interface ReplayWish {
  readonly rate: number;
  readonly span: Span;
  readonly isLooping: boolean;
  readonly copies: number;
  readonly jitterMs: number;
  readonly conflict: ReplayConflict;
  /** Empty unless live records are moved. */
  readonly livePrefix: string;
}

/** @throws ServiceError when the request asks for what there is not */
export function wishOf(
  request: ReplayStartRequest,
  facts: ReplayFacts,
  limits: LimitWatch,
): ReplayWish {
  const { isGhost, jitterMs, sessionId } = request;
  require(!isGhost ||
    sessionId === '', 'A ghost runs no session again. Leave session_id out, or is_ghost.');
  const conflict = isGhost ? ReplayConflict.REPLAY_CONFLICT_KEEP_LIVE : request.conflict;
  const isMoving = conflict === ReplayConflict.REPLAY_CONFLICT_MOVE_LIVE;
  require(jitterMs >= 0 &&
    jitterMs <=
      MAX_JITTER_MS, `The member jitter_ms is ${jitterMs}, but it is 0 to ${MAX_JITTER_MS} milliseconds.`);
  return {
    conflict,
    jitterMs,
    copies: copiesOf(request, limits),
    rate: request.rate === 0 ? 1 : rateOf(request.rate),
    span: spanOf(request.span, facts),
    isLooping: isGhost || request.isLooping,
    livePrefix: isMoving ? request.livePrefix || DEFAULT_LIVE_PREFIX : '',
  };
}

/** @throws ServiceError when it is no rate */
export function rateOf(rate: number): number {
  require(rate >= MIN_RATE &&
    rate <=
      MAX_RATE, `The member rate is ${rate}, but a replay has a rate of ${MIN_RATE} to ${MAX_RATE}.`);
  return rate;
}

/** The span in the time of the recording; all of it when absent. @throws ServiceError when there is none such */
export function spanOf(span: ReplaySpan | undefined, { startNs, endNs }: ReplayFacts): Span {
  if (span === undefined) return { fromNs: startNs, untilNs: endNs };
  const { fromMs, untilMs } = span;
  const durationMs = Number(endNs - startNs) / NS_PER_MS;
  const until = untilMs === 0 ? durationMs : Math.min(untilMs, durationMs);
  require(fromMs >= 0 &&
    fromMs <
      until, `The span from ${fromMs} to ${untilMs} ms is not within the recording, which has ${durationMs} ms.`);
  return { fromNs: momentOf(fromMs, startNs), untilNs: momentOf(until, startNs) };
}

/** @param ms since the start of the recording @throws ServiceError when it is no number */
export function momentOf(ms: number, startNs: bigint): bigint {
  require(Number.isFinite(ms), `The position ${ms} is no number of milliseconds.`);
  return startNs + BigInt(Math.round(ms * NS_PER_MS));
}

/** Milliseconds from one moment to the other. */
export function msBetween(fromNs: bigint, untilNs: bigint): number {
  return Number(untilNs - fromNs) / NS_PER_MS;
}

/** [RP-3] */
function copiesOf({ isGhost, copies }: ReplayStartRequest, limits: LimitWatch): number {
  require(copies >= 0, `The member copies is ${copies}, but a ghost has 1 copy or more.`);
  if (copies === 0) return 1;
  require(isGhost ||
    copies === 1, 'Only a ghost has several copies. Set is_ghost, or leave copies out.');
  const max = limits.limits.replayCopies;
  if (copies > max) throw limits.refusal('replayCopies', `more than ${max} copies of a ghost`);
  return copies;
}

function require(isRight: boolean, message: string): void {
  if (!isRight) throw new ServiceError('invalid_argument', message);
}
