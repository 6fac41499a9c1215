import { ComponentIOType, matchesProfile, type Component } from '@ubii/proto';

import { isEventValue } from '../records/parse-event.ts';
import type {
  RecordedDevice,
  RecordingEvent,
  RecordedComponent,
} from '../records/recording-event.ts';

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

/** Returns whether any value from outside is a device. */
export function isRecordedDevice(value: unknown): value is RecordedDevice {
  return isEventValue('device', value);
}

/** Returns the topics of the recorded components that a profile selects, as it would select live ones. [PM-41] */
export function topicsOfProfile(profile: Component, devices: readonly RecordedDevice[]): string[] {
  const topics = devices.flatMap(({ id, components }) =>
    components
      .filter(
        (component) => publishes(component) && matchesProfile(asProfiled(component, id), profile),
      )
      .map(({ topic }) => topic),
  );
  return [...new Set(topics)];
}

/** Ids of the devices that had a component which published on a topic, by topic. */
export function devicesByTopic(devices: readonly RecordedDevice[]): ReadonlyMap<string, string> {
  return new Map(
    devices.flatMap(({ id, components }) =>
      components.filter(publishes).map(({ topic }) => [topic, id] as const),
    ),
  );
}

function publishes({ topic, direction }: RecordedComponent): boolean {
  return direction !== 'subscriber' && topic !== '';
}

function asProfiled({ id, name, format, tags }: RecordedComponent, deviceId: string) {
  return { id, name, messageFormat: format, deviceId, tags, ioType: ComponentIOType.PUBLISHER };
}
