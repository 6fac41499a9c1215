import type { RecordedComponent, RecordedDevice } from '../records/recording-event.ts';

/** A recorded device whose components publish numbers, unless they say otherwise. */
export function recordedDevice(
  id: string,
  clientId: string,
  components: readonly Partial<RecordedComponent>[],
  more: Partial<RecordedDevice> = {},
): RecordedDevice {
  const complete = components.map((component, index) => ({
    id: `${id}-${index}`,
    name: `component ${index}`,
    topic: '',
    format: 'double',
    direction: 'publisher',
    tags: [],
    ...component,
  }));
  return { id, clientId, name: id, tags: [], state: 'registered', components: complete, ...more };
}
