import type { TopicRate } from '../../connection/topic-rates.ts';

/** Nothing is stale before this age, milliseconds. */
const FRESH_MS = 5000;
/** Topics that come less often than this are settings, not streams, Hz. */
const STREAM_HZ = 0.5;
/** A stream is late after this many of its usual gaps. */
const LATE_GAPS = 5;

/**
 * Whether the newest record is older than it should be: its client is away, or it came regularly and
 * does no more. A setting that was made long ago is old, not stale.
 */
export function isStale(
  { statistic, usualHz }: TopicRate,
  isPublisherAway: boolean,
  nowMs: number,
): boolean {
  const ageMs = nowMs - statistic.publishedMs;
  if (statistic.publishedMs === 0 || ageMs < FRESH_MS) return false;
  if (isPublisherAway) return true;
  return usualHz !== undefined && usualHz >= STREAM_HZ && ageMs > (LATE_GAPS * 1000) / usualHz;
}
