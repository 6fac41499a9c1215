import type { Timestamp } from './generated/messages.ts';

/** Earliest moment taken for a wall-clock time: 2001-09-09, milliseconds since the Unix epoch. */
const EARLIEST_EPOCH_MS = 1e12;

/**
 * Writes a moment into all three fields, so that every existing client finds it where it looks.
 *
 * @param epochMs milliseconds since the Unix epoch; a fraction is kept in `nanos`
 */
export function timestampFromMs(epochMs: number): Timestamp {
  const seconds = Math.floor(epochMs / 1000);
  return {
    seconds,
    nanos: Math.min(Math.round((epochMs - seconds * 1000) * 1e6), 999_999_999),
    millis: Math.floor(epochMs),
  };
}

/**
 * Reads a moment: milliseconds since the Unix epoch, or undefined when there is none.
 *
 * Clients disagree on the three fields: Node.js fills `millis` with epoch time, older browser
 * clients `seconds` and `nanos`, newer ones `millis` with the time since the page was loaded, Unity
 * `seconds` with the second of the minute. The last two cannot be compared with any other clock and
 * count as none.
 */
export function timestampToMs(timestamp: Timestamp | undefined): number | undefined {
  if (timestamp === undefined) return undefined;
  const { seconds, nanos, millis } = timestamp;
  const fine = seconds * 1000 + nanos / 1e6;
  const hasFine = fine >= EARLIEST_EPOCH_MS;
  if (millis < EARLIEST_EPOCH_MS) return hasFine ? fine : undefined;
  return hasFine && Math.abs(fine - millis) < 1 ? fine : millis;
}
