import { Publication, type PublishingClient } from '../core/topics/publication.ts';
import type { LiveRule, ReplayedTopics } from '../core/topics/replayed-topics.ts';

const REPLAY = { id: 'replay' } as PublishingClient;

/** A rule that refuses the live records of all. */
export function liveRule(): LiveRule {
  return {
    clientIds: new Set([REPLAY.id]),
    livePrefix: undefined,
    mutes: () => true,
    mayMove: () => false,
    onMoved: () => undefined,
    onLive: () => undefined,
  };
}

/** Has the first record of the replay accepted. */
export function playFirst(replayed: ReplayedTopics, topic: string): void {
  const publication = new Publication();
  publication.client = REPLAY;
  publication.topic = topic;
  replayed.ruleFor(publication);
}
