import { clientOfPointerTopic } from '../../../examples/mouse-pointer/pointer-topic.ts';

/** What is known of a live topic. */
export interface LiveTopic {
  readonly topic: string;
  readonly format: string;
  readonly hz: number;
}

const TOUCH = /^\/[^/]+\/[^/]+\/touch_position$/;

/**
 * Returns the live topic with a pointer position: prefers a pointer that moves now, then those of
 * others, so that a phone in the hand counts more than the mouse beside it.
 */
export function livePointer(topics: Iterable<LiveTopic>, ownId: string): string | undefined {
  const isOwn = (topic: string): boolean => topic.startsWith(`/${ownId}/`);
  return [...topics]
    .filter(({ format }) => format === 'vector2')
    .filter(({ topic }) => clientOfPointerTopic(topic) !== undefined || TOUCH.test(topic))
    .sort(
      (a, b) =>
        Number(b.hz > 0) - Number(a.hz > 0) ||
        Number(isOwn(a.topic)) - Number(isOwn(b.topic)) ||
        a.topic.localeCompare(b.topic),
    )
    .at(0)?.topic;
}
