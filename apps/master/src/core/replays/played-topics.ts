import { compileGlob } from '@ubii/patterns';
import { isMasterTopic, ServiceError, type ReplayRename } from '@ubii/proto';
import type { RecordedTopic } from '@ubii/recording';
import { topicFault } from '../topics/topic-names.ts';
import { quote } from '../texts/quote.ts';

/** Recorded topics with the names under which they are published. */
export type PlayedTopics = ReadonlyMap<string, string>;

/** Which topics of a recording are played. */
export interface TopicChoice {
  /** Globs; empty for all. */
  readonly topics: readonly string[];
  readonly excludedTopics: readonly string[];
}

/** Returns the topics to play. [RP-12] @throws ServiceError when there is none */
export function chosenTopics(
  recorded: readonly RecordedTopic[],
  { topics, excludedTopics }: TopicChoice,
): readonly RecordedTopic[] {
  const wanted = topics.map(compileGlob);
  const excluded = excludedTopics.map(compileGlob);
  const chosen = recorded.filter(
    ({ topic, isRaw }) =>
      !isRaw &&
      (wanted.length === 0 || wanted.some((test) => test(topic))) &&
      !excluded.some((test) => test(topic)),
  );
  if (chosen.length > 0) return chosen;
  throw new ServiceError(
    'invalid_argument',
    'The recording has no topic that can be played and is selected. Change topics or excluded_topics.',
  );
}

/** Gives topics their new names. [RP-13] @throws ServiceError when two get the same, or one that cannot be published on */
export function renamedTopics(
  recorded: readonly RecordedTopic[],
  renames: readonly ReplayRename[],
  maxBytes: number,
): PlayedTopics {
  // The longest prefix counts.
  const ordered = [...renames].sort((a, b) => b.fromPrefix.length - a.fromPrefix.length);
  const played = new Map<string, string>();
  const sources = new Map<string, string>();
  for (const { topic } of recorded) {
    const rename = ordered.find(({ fromPrefix }) => topic.startsWith(fromPrefix));
    const name =
      rename === undefined ? topic : rename.toPrefix + topic.slice(rename.fromPrefix.length);
    requirePublishable(name, maxBytes);
    const other = sources.get(name) ?? topic;
    if (other !== topic) {
      throw new ServiceError(
        'invalid_argument',
        `The recorded topics ${quote(other)} and ${quote(topic)} would both be played as ${quote(name)}. Change renames.`,
      );
    }
    sources.set(name, topic);
    played.set(topic, name);
  }
  return played;
}

/** Gives topics the names of one copy of a ghost. [RP-31] @param number of the copy, among all copies of the master */
export function ghostTopics(
  recorded: readonly RecordedTopic[],
  clientId: string,
  number: number,
): PlayedTopics {
  const played = new Map<string, string>();
  const used = new Set<string>();
  for (const { topic, clientId: recordedId } of recorded) {
    if (played.has(topic)) continue;
    const prefix = `/${recordedId}/`;
    const own = `/${clientId}/${topic.slice(prefix.length)}`;
    const isOwn = recordedId !== '' && topic.startsWith(prefix) && !used.has(own);
    const name = isOwn ? own : `/ghost-${number}${topic.startsWith('/') ? '' : '/'}${topic}`;
    used.add(name);
    played.set(topic, name);
  }
  return played;
}

/** Checks where live records of these topics would be moved. [RP-45] @throws ServiceError when none may be published there */
export function requireMovable(
  names: ReadonlySet<string>,
  livePrefix: string,
  maxBytes: number,
  mayMoveTo: (topic: string) => boolean,
): void {
  for (const name of names) {
    const moved = livePrefix + name;
    const fault = topicFault(moved, maxBytes);
    const isTaken = isMasterTopic(moved) || names.has(moved) || !mayMoveTo(moved);
    if (fault === undefined && !isTaken) continue;
    const why = fault ?? 'belongs to the master, to a client or to the replay';
    throw new ServiceError(
      'invalid_argument',
      `Live records cannot be moved to ${quote(moved)}, because this topic ${why}. Change live_prefix.`,
    );
  }
}

function requirePublishable(topic: string, maxBytes: number): void {
  const fault = topicFault(topic, maxBytes);
  if (fault === undefined && !isMasterTopic(topic)) return;
  const why = fault ?? 'belongs to the master';
  throw new ServiceError(
    'invalid_argument',
    `A replay cannot publish on ${quote(topic)}, because this topic ${why}. Leave the topic out, or rename it.`,
  );
}
