import { decodeRecord, type FlightRecord, type TopicRecord } from '@ubii/proto';
import { sameValue } from '../../formats/same-value.ts';
import type { KeptRecord } from './record-log.ts';
import type { TopicHistory } from './topic-history.ts';

/** Records that are taken between two turns of the page: some milliseconds of work. */
const RECORDS_A_TURN = 500;

interface PastRecord {
  readonly record: TopicRecord;
  /** This computer's clock. */
  readonly timeMs: number;
}

/**
 * Puts what came before a topic was opened at the beginning of its history.
 *
 * @param past oldest first; the times are of this computer's clock
 * @param pause gives the page a turn
 */
export async function fillPast(
  history: TopicHistory,
  past: readonly FlightRecord[],
  pause: () => Promise<void>,
): Promise<void> {
  const decoded: PastRecord[] = [];
  await inTurns(past, pause, ({ timeMs, record: bytes }) => {
    const record = decodeRecord(bytes);
    if (record.format !== undefined) decoded.push({ record, timeMs });
  });
  const first = history.records.oldest;
  const before = first === undefined ? decoded : thoseBefore(decoded, first);
  if (before.length === 0) return;
  const earlier = history.before(before.length);
  await inTurns(before, pause, ({ record, timeMs }) => earlier.add(record, timeMs));
  history.beginWith(earlier);
}

/** The last of the past have come as new ones, too. */
function thoseBefore(past: readonly PastRecord[], first: KeptRecord): readonly PastRecord[] {
  // Several may have been measured in the same millisecond.
  const at = past.findLastIndex(({ record }) => isSame(record, first));
  return at >= 0 ? past.slice(0, at) : past.filter(({ timeMs }) => timeMs < first.localMs);
}

function isSame(record: TopicRecord, { timestampMs, clientId, value }: KeptRecord): boolean {
  if (timestampMs === undefined || record.timestampMs !== timestampMs) return false;
  return record.clientId === clientId && sameValue(record.value, value);
}

async function inTurns<T>(
  all: readonly T[],
  pause: () => Promise<void>,
  take: (one: T) => void,
): Promise<void> {
  for (const [index, one] of all.entries()) {
    take(one);
    if (index % RECORDS_A_TURN === RECORDS_A_TURN - 1) await pause();
  }
}
