import type { FlightSnapshot } from '../recorder/flight-recorder.ts';
import type { SnapshotPart } from './thread-messages.ts';

/** Elements of each list in a part: copying more for a message would hold up the thread that forwards records. */
const ELEMENTS = 500;

/** A snapshot in parts. */
export function* partsOf({ channels, standing, events }: FlightSnapshot): Generator<SnapshotPart> {
  const most = Math.max(channels.length, standing.length, events.length);
  for (let from = 0; from < most; from += ELEMENTS) {
    const until = from + ELEMENTS;
    yield {
      channels: channels.slice(from, until),
      standing: standing.slice(from, until),
      events: events.slice(from, until),
    };
  }
}
