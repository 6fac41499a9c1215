import type { TopicRate } from '../../connection/topic-rates.ts';

/** Smallest age of a stale record, milliseconds. */
const FRESH_MS = 5000;
/** Rate below which topics count as settings instead of streams, Hz. */
const STREAM_HZ = 0.5;
/** Number of usual intervals after which a stream is stale. */
const LATE_GAPS = 5;

/**
 * Whether the newest record is stale: its client is away, or records that arrived regularly stopped. An old record of a
 * setting is not stale.
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
