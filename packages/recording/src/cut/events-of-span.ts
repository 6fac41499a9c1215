import type { Gap, RecordingEvent } from '../records/recording-event.ts';
import { stateKey } from '../records/state-key.ts';

/** Nanoseconds since the Unix epoch, both inclusive. */
export interface SpanNs {
  readonly fromNs: bigint;
  readonly untilNs: bigint;
}

/**
 * The events that apply in a span, by time: states from before at its beginning, markers as they are now, gaps that reach
 * into it.
 *
 * @param events in the order in which they were written
 */
export function eventsOfSpan(
  events: readonly RecordingEvent[],
  { fromNs, untilNs }: SpanNs,
): RecordingEvent[] {
  const before = new Map<string, RecordingEvent>();
  const markers = new Map<string, RecordingEvent>();
  const within: RecordingEvent[] = [];
  for (const event of events) {
    const key = stateKey(event);
    if (event.kind === 'marker') markers.set(event.value.id, event);
    else if (event.kind === 'gap') {
      if (reaches(event.value, { fromNs, untilNs })) within.push(event);
    } else if (key !== undefined && event.timeNs < fromNs) before.set(key, event);
    else if (event.timeNs <= untilNs) within.push(event);
  }
  for (const event of markers.values()) {
    const isWithin = event.timeNs >= fromNs && event.timeNs <= untilNs;
    const isRemoved = event.kind === 'marker' && event.value.isRemoved === true;
    if (isWithin && !isRemoved) within.push(event);
  }
  within.sort((a, b) => (a.timeNs === b.timeNs ? 0 : a.timeNs < b.timeNs ? -1 : 1));
  return [...Array.from(before.values(), (event) => ({ ...event, timeNs: fromNs })), ...within];
}

function reaches({ fromMs, untilMs }: Gap, { fromNs, untilNs }: SpanNs): boolean {
  return fromMs * 1e6 <= Number(untilNs) && untilMs * 1e6 >= Number(fromNs);
}
