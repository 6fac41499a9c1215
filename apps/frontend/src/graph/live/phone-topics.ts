import { SMART_DEVICE_COMPONENTS } from '../../devices/smart-device/components.ts';
import type { KnownTopic } from '../model/fit/node-offer.ts';

const PUBLISHERS = SMART_DEVICE_COMPONENTS.filter((component) => !('ioType' in component));

/** Returns the topics that the smart device of a client publishes while its page is open. */
export function phoneTopics(clientId: string): KnownTopic[] {
  return PUBLISHERS.map(({ topic, format }) => ({ topic: topic(clientId), format }));
}

/** Returns the tags of the smart device component that publishes on a topic; undefined for other topics. */
export function phoneTopicTags(topic: string, clientId: string): readonly string[] | undefined {
  return PUBLISHERS.find((component) => component.topic(clientId) === topic)?.tags;
}

/** Whether a topic has the touch position of this browser's smart device. */
export function isOwnTouch(topic: string, ownId: string): boolean {
  return phoneTopicTags(topic, ownId)?.includes('touch') ?? false;
}
