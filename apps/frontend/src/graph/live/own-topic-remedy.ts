import type { Remedy } from '../model/live/graph-problem.ts';
import { phoneTopicTags } from './phone-topics.ts';

const SMART_DEVICE_PATH = '/devices/smart-device';

/**
 * Returns advice about a topic of this browser's smart device without a value; undefined for other topics.
 * @param openPad opens the touch pad, on pages that have one
 */
export function ownTopicRemedy(
  topic: string,
  ownId: string,
  openPad?: () => void,
): Remedy | undefined {
  const tags = phoneTopicTags(topic, ownId);
  if (tags === undefined) return undefined;
  const name = topic.slice(topic.lastIndexOf('/') + 1);
  if (openPad !== undefined && tags.includes('touch')) {
    return {
      message: `Nothing is sent to ${name} yet. Open the touch pad below, and touch it.`,
      text: 'Open the touch pad',
      run: openPad,
    };
  }
  return {
    message: `Nothing is sent to ${name}. Open Smart device and ${deed(tags)}: it publishes while its page is open.`,
    text: 'Open Smart device',
    to: SMART_DEVICE_PATH,
  };
}

function deed(tags: readonly string[]): string {
  if (tags.includes('touch')) return 'touch the pad';
  if (tags.includes('button')) return 'press a button';
  if (tags.includes('text')) return 'send a text';
  return 'allow its sensors';
}
