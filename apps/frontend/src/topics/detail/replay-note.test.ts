import { ReplayConflict, type Replay } from '@ubii/proto';
import { expect, it } from 'vitest';
import { replayNote } from './replay-note.ts';

const replay = (change: Partial<Replay>): Replay =>
  ({ recordingName: 'Study', mutedTopics: [], clientIds: ['r'], ...change }) as Replay;

it('a topic says that a replay mutes or moves its live records, or publishes it', () => {
  const muting = replay({
    mutedTopics: ['/a'],
    conflict: ReplayConflict.REPLAY_CONFLICT_MUTE_LIVE,
  });
  expect(replayNote([muting], '/a', 'r')).toBe(
    'Live records are muted until the replay of recording “Study” stops.',
  );
  const moving = { conflict: ReplayConflict.REPLAY_CONFLICT_MOVE_LIVE, livePrefix: '/live' };
  expect(replayNote([replay({ ...moving, mutedTopics: ['/a'] })], '/a', 'r')).toBe(
    'Live records are on /live/a until the replay of recording “Study” stops.',
  );
  expect(replayNote([muting], '/b', 'r')).toBe(
    'These records are replayed from recording “Study”.',
  );
  expect(replayNote([muting], '/b', 'ada')).toBeUndefined();
  expect(replayNote([muting], '/b', undefined)).toBeUndefined();
});
