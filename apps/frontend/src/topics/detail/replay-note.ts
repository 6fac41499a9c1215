import { ReplayConflict, type Replay } from '@ubii/proto';

/**
 * Why a topic has recorded values, or no live ones, one sentence; undefined when no replay plays it.
 *
 * @param publisherId client of the newest record
 */
export function replayNote(
  replays: readonly Replay[],
  topic: string,
  publisherId: string | undefined,
): string | undefined {
  const muting = replays.find(({ mutedTopics }) => mutedTopics.includes(topic));
  if (muting !== undefined) {
    const until = `until the replay of recording “${muting.recordingName}” stops.`;
    return muting.conflict === ReplayConflict.REPLAY_CONFLICT_MOVE_LIVE
      ? `Live records are on ${muting.livePrefix}${topic} ${until}`
      : `Live records are muted ${until}`;
  }
  const playing = replays.find(({ clientIds }) => clientIds.includes(publisherId ?? ''));
  return playing && `These records are replayed from recording “${playing.recordingName}”.`;
}
