import { decodeRecord, isSameValue, type FlightRecord, type TopicRecord } from '@ubii/proto';
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
  // Several may have been measured in the same millisecond.
  const at =
    first === undefined ? -1 : decoded.findLastIndex(({ record }) => isSame(record, first));
  const before =
    at >= 0
      ? decoded.slice(0, at + 1)
      : decoded.filter(({ timeMs }) => timeMs < (first?.localMs ?? Infinity));
  if (before.length === 0) return;
  const lastNumber = (first?.number ?? 1) - (at >= 0 ? 0 : 1);
  const earlier = history.before(before.length - lastNumber);
  await inTurns(before, pause, ({ record, timeMs }) => earlier.add(record, timeMs));
  history.beginWith(earlier);
}

function isSame(record: TopicRecord, { timestampMs, clientId, value }: KeptRecord): boolean {
  if (timestampMs === undefined || record.timestampMs !== timestampMs) return false;
  return record.clientId === clientId && isSameValue(record.value, value);
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
