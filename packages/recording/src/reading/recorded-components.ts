import { ComponentIOType, matchesProfile, type Component } from '@ubii/proto';
import type { RecordedComponent, RecordedDevice } from '../records/recording-event.ts';

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
