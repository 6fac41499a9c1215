import { isEventValue } from '../records/parse-event.ts';
import type { RecordedDevice, RecordingEvent } from '../records/recording-event.ts';

/** A span of times, nanoseconds since the Unix epoch, both ends inclusive. */
interface Span {
  readonly fromNs: bigint;
  readonly untilNs: bigint;
}

/**
 * Finds the devices that were registered at any time in a span, in the order of their registration: a device that was registered
 * again with other members has several versions.
 *
 * @param events in the order in which they were written
 */
export function devicesInSpan(
  events: readonly RecordingEvent<'device'>[],
  { fromNs, untilNs }: Span,
): RecordedDevice[] {
  const found = new Map<string, RecordedDevice>();
  const known = new Map<string, RecordedDevice>();
  for (const { timeNs, value } of events) {
    if (timeNs > untilNs) continue;
    const before = known.get(value.id);
    // The one before ends here, within the span.
    if (before !== undefined && timeNs > fromNs) found.set(JSON.stringify(before), before);
    if (value.state === 'registered') known.set(value.id, value);
    else known.delete(value.id);
  }
  for (const device of known.values()) found.set(JSON.stringify(device), device);
  return [...found.values()];
}

/** Tells whether a value from outside, which may be anything, is a device. */
export function isRecordedDevice(value: unknown): value is RecordedDevice {
  return isEventValue('device', value);
}
