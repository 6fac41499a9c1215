import { clientOfPointerTopic } from '../../../devices/pointer-topic.ts';

/** Statistics of a live topic. */
export interface LiveTopic {
  readonly topic: string;
  readonly format: string;
  readonly hz: number;
}

const TOUCH = /^\/[^/]+\/[^/]+\/touch_position$/;

/**
 * Returns the live topic with a pointer position: prefers a moving pointer, so that a phone in use takes precedence
 * over an idle mouse, then that of this browser.
 * @param onlyOwn only topics of this browser: on a phone, users expect their own touch
 */
export function livePointer(
  topics: Iterable<LiveTopic>,
  ownId: string,
  onlyOwn = false,
): string | undefined {
  const isOwn = (topic: string): boolean => topic.startsWith(`/${ownId}/`);
  return [...topics]
    .filter(({ format }) => format === 'vector2')
    .filter(({ topic }) => clientOfPointerTopic(topic) !== undefined || TOUCH.test(topic))
    .filter(({ topic }) => !onlyOwn || isOwn(topic))
    .sort(
      (a, b) =>
        Number(b.hz > 0) - Number(a.hz > 0) ||
        Number(isOwn(b.topic)) - Number(isOwn(a.topic)) ||
        a.topic.localeCompare(b.topic),
    )
    .at(0)?.topic;
}
