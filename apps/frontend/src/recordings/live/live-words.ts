import { ReplayConflict, ReplayState, type Replay } from '@ubii/proto';
import { capitalised, counted, plural } from '@ubii/words';
import { formatNumber } from '../../ui/readouts/format-number.ts';

/** Name of a replay. The master numbers the copies of a ghost, and names the replay after the first. */
export const replayName = ({ name, copies }: Pick<Replay, 'name' | 'copies'>): string =>
  copies > 1 ? name.replace(/^1: /, '') : name;

/** Who plays what, one sentence. */
export function replaySentence(replay: Replay): string {
  const { author, recordingName, copies, isGhost, session, topicCount } = replay;
  const recording = `“${recordingName}”`;
  if (session !== undefined)
    return `Session “${session.name}” runs again on recording ${recording}.`;
  if (isGhost) {
    const named = `“${replayName(replay)}”`;
    const what = copies > 1 ? `${copies} copies of ${named} play` : `${named} plays`;
    return `${what} in a loop.`;
  }
  const who = author || 'A program';
  return `${who} plays recording ${recording} into ${counted(topicCount, 'live topic')}.`;
}

/** What happens to live records because of a replay, one sentence; empty for one that changes none. */
export function conflictSentence(replay: Replay): string {
  const { conflict, mutedCount, mutedTopics, livePrefix, isGhost, session } = replay;
  if (isGhost || session !== undefined) return '';
  if (conflict === ReplayConflict.REPLAY_CONFLICT_KEEP_LIVE)
    return 'Live records of the same topics are published as well.';
  const isMuted = conflict === ReplayConflict.REPLAY_CONFLICT_MUTE_LIVE;
  const done = isMuted ? 'muted' : `moved below ${livePrefix}`;
  if (mutedCount === 0) return `Live records of these topics are ${done}.`;
  const records = `${formatNumber(mutedCount)} live ${plural(mutedCount, 'record')}`;
  const topics =
    mutedTopics.length < MAX_TOPICS ? ` on ${counted(mutedTopics.length, 'topic')}` : '';
  return `${records}${topics} ${done} so far.`;
}

/** The master names no more muted topics. */
const MAX_TOPICS = 100;

/** The banner of the page whose recording is played. @param publishers of the same topics, when this page knows them */
export function bannerSentence(replay: Replay, publishers: readonly string[]): string {
  const playing = 'This recording is playing into live topics.';
  const isMuted = replay.conflict === ReplayConflict.REPLAY_CONFLICT_MUTE_LIVE;
  if (!isMuted || publishers.length === 0) return `${playing} ${conflictSentence(replay)}`;
  const who = listed(publishers);
  const subject = publishers[0] === MODULES ? capitalised(who) : who;
  return `${playing} ${subject} ${plural(publishers[0] === MODULES ? 2 : publishers.length, 'is', 'are')} muted until you stop.`;
}

/** The publisher of what modules of sessions on the master write. */
export const MODULES = 'modules of the master';

/** Names as people list them: `a, b and c`; the rest of many as a number. */
export function listed(names: readonly string[]): string {
  const shown = names.slice(0, MAX_NAMES);
  const rest = names.length - shown.length;
  if (rest > 0) return `${shown.join(', ')} and ${counted(rest, 'other client')}`;
  return names.length < 2
    ? (names[0] ?? '')
    : `${names.slice(0, -1).join(', ')} and ${names.at(-1)!}`;
}

const MAX_NAMES = 3;

/** State of a replay, one word. */
export function replayStateWord({ state }: Pick<Replay, 'state'>): string {
  switch (state) {
    case ReplayState.REPLAY_STATE_PLAYING:
      return 'Playing';
    case ReplayState.REPLAY_STATE_ENDED:
      return 'Ended';
    case ReplayState.REPLAY_STATE_FAILED:
      return 'Failed';
    default:
      return 'Paused';
  }
}
