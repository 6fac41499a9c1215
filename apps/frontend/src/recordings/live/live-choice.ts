import {
  ReplayConflict,
  type Init,
  type ReplayRename,
  type ReplayStartRequest,
  type TopicStatistic,
} from '@ubii/proto';
import { compileGlob } from '@ubii/patterns';
import type { PlayerState } from '../reading/recording-messages.ts';

/** What happens to live records of the topics that are played. */
export type LiveConflict = 'mute' | 'move' | 'keep';

/** How a recording is played into live topics. */
export interface LiveChoice {
  readonly by: 'all' | 'topics';
  readonly topics: readonly string[];
  /** Globs, separated by spaces, commas or lines; in addition to `topics`. */
  readonly patterns: string;
  /** Globs of topics that are left out, likewise. */
  readonly excluded: string;
  readonly renames: readonly PrefixRename[];
  readonly conflict: LiveConflict;
  readonly livePrefix: string;
  readonly keepsTimestamps: boolean;
}

export interface PrefixRename {
  readonly from: string;
  readonly to: string;
}

export const DEFAULT_LIVE_CHOICE: LiveChoice = {
  by: 'all',
  topics: [],
  patterns: '',
  excluded: '',
  renames: [],
  conflict: 'mute',
  livePrefix: '/live',
  keepsTimestamps: false,
};

/** Returns the recorded topics that a choice plays. */
export function chosenTopics(choice: LiveChoice, recorded: readonly string[]): readonly string[] {
  const excludes = anyOf(globsOf(choice.excluded));
  const includes = choice.by === 'all' ? () => true : anyOf(includedGlobs(choice));
  return recorded.filter((topic) => includes(topic) && !excludes(topic));
}

/** Returns the live topic of a recorded one: the longest prefix of the renames counts. [RP-13] */
export function renamedTopic(topic: string, renames: readonly PrefixRename[]): string {
  const [longest] = usedRenames(renames)
    .filter(({ from }) => topic.startsWith(from))
    .sort((a, b) => b.from.length - a.from.length);
  return longest === undefined ? topic : longest.to + topic.slice(longest.from.length);
}

/** Returns the request that plays a choice with rate and loop of the page. It begins paused. */
export function liveRequest(
  choice: LiveChoice,
  recordingId: string,
  { rate, loop }: Pick<PlayerState, 'rate' | 'loop'>,
): Init<ReplayStartRequest> {
  return {
    recordingId,
    rate,
    isPaused: true,
    isLooping: loop !== undefined,
    topics: choice.by === 'all' ? [] : includedGlobs(choice),
    excludedTopics: globsOf(choice.excluded),
    renames: usedRenames(choice.renames).map(({ from, to }): Init<ReplayRename> => ({
      fromPrefix: from,
      toPrefix: to,
    })),
    conflict: CONFLICTS[choice.conflict],
    livePrefix: choice.conflict === 'move' ? choice.livePrefix.trim() : '',
    keepsTimestamps: choice.keepsTimestamps,
    ...(loop && { span: { fromMs: loop.fromMs, untilMs: loop.untilMs } }),
  };
}

/** A client that publishes topics now. */
export interface LivePublisher {
  /** Empty for the master. */
  readonly clientId: string;
  readonly topics: readonly string[];
}

/** Finds the clients that publish some of these topics now, those with most topics first. */
export function livePublishers(
  liveTopics: ReadonlySet<string>,
  rates: Iterable<{ readonly statistic: Pick<TopicStatistic, 'topic' | 'publisherId'> }>,
): readonly LivePublisher[] {
  const found = new Map<string, string[]>();
  for (const { statistic } of rates) {
    if (!liveTopics.has(statistic.topic)) continue;
    const topics = found.get(statistic.publisherId) ?? [];
    topics.push(statistic.topic);
    found.set(statistic.publisherId, topics);
  }
  return [...found]
    .map(([clientId, topics]) => ({ clientId, topics }))
    .sort((a, b) => b.topics.length - a.topics.length);
}

/** What is wrong with the prefix of a topic. */
export function prefixError(prefix: string): string | undefined {
  const text = prefix.trim();
  if (!text.startsWith('/')) return 'Begin the prefix with a slash, such as /live.';
  return text.length > 1 && text.endsWith('/') ? 'Remove the slash at the end.' : undefined;
}

const CONFLICTS: Readonly<Record<LiveConflict, ReplayConflict>> = {
  mute: ReplayConflict.REPLAY_CONFLICT_MUTE_LIVE,
  move: ReplayConflict.REPLAY_CONFLICT_MOVE_LIVE,
  keep: ReplayConflict.REPLAY_CONFLICT_KEEP_LIVE,
};

const globsOf = (text: string): string[] => text.split(/[\s,]+/).filter(Boolean);
const includedGlobs = ({ topics, patterns }: LiveChoice): string[] => [
  ...topics,
  ...globsOf(patterns),
];
const usedRenames = (renames: readonly PrefixRename[]): PrefixRename[] =>
  renames.filter(({ from }) => from !== '');

function anyOf(globs: readonly string[]): (topic: string) => boolean {
  const selects = globs.map(compileGlob);
  return (topic) => selects.some((select) => select(topic));
}
