import { ComponentIOType, decode, encode, type Component, type Device } from '@ubii/proto';
import type { RecordedComponent, RecordedDevice } from '@ubii/recording';
import type { PlayedTopics } from './played-topics.ts';

/**
 * Makes the devices of one copy of a ghost: those that had a component on a topic that it plays, with their components on the
 * topics of the copy. [RP-33]
 *
 * @param recorded as they were in the span; of several versions of a device, the last one counts
 * @param mayHave whether a component is registered; others are left out
 */
export function ghostDevices(
  recorded: readonly RecordedDevice[],
  played: PlayedTopics,
  clientId: string,
  mayHave: (component: Pick<Component, 'topic' | 'ioType'>) => boolean,
): Device[] {
  const last = new Map(recorded.map((device) => [device.id, device]));
  return [...last.values()].flatMap((device) => {
    const components = device.components.flatMap((component) => {
      const topic = topicOf(component, device.clientId, played, clientId);
      const made = topic === undefined ? undefined : componentOf(component, topic);
      return made !== undefined && mayHave(made) ? made : [];
    });
    const isPlayed = components.some(({ ioType }) => ioType === ComponentIOType.PUBLISHER);
    if (!isPlayed) return [];
    const { name, tags } = device;
    const message = { name, tags, components, clientId };
    return decode('ubii.devices.Device', encode('ubii.devices.Device', message));
  });
}

/** Undefined for a topic that is not played. What is meant for the recorded client is meant for the copy. */
function topicOf(
  { topic, direction }: RecordedComponent,
  recordedId: string,
  played: PlayedTopics,
  clientId: string,
): string | undefined {
  if (direction !== 'subscriber') return played.get(topic);
  const own = `/${recordedId}/`;
  return topic.startsWith(own) ? `/${clientId}/${topic.slice(own.length)}` : topic;
}

function componentOf({ name, format, direction, tags }: RecordedComponent, topic: string) {
  const isInput = direction === 'subscriber';
  const ioType = isInput ? ComponentIOType.SUBSCRIBER : ComponentIOType.PUBLISHER;
  return { name, topic, messageFormat: format, ioType, tags };
}
