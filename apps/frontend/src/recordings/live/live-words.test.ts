import { ReplayConflict } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { bannerSentence, conflictSentence, listed, replaySentence } from './live-words.ts';
import { aReplay } from './testing/replay-page.ts';

describe('words of replays', () => {
  it('say who plays what', () => {
    expect(replaySentence(aReplay())).toBe('Ada plays recording “Study” into 2 live topics.');
    expect(replaySentence(aReplay({ author: '', topicCount: 1 }))).toBe(
      'A program plays recording “Study” into 1 live topic.',
    );
    const ghost = { name: 'Visitor', isGhost: true };
    expect(replaySentence(aReplay(ghost))).toBe('“Visitor” plays in a loop.');
    expect(replaySentence(aReplay({ ...ghost, name: '1: Visitor', copies: 3 }))).toBe(
      '3 copies of “Visitor” play in a loop.',
    );
  });

  it('say what happens to live records, and how many it were', () => {
    expect(conflictSentence(aReplay())).toBe('Live records of these topics are muted.');
    expect(conflictSentence(aReplay({ mutedCount: 24, mutedTopics: ['/a'] }))).toBe(
      '24 live records on 1 topic muted so far.',
    );
    const moved = { conflict: ReplayConflict.REPLAY_CONFLICT_MOVE_LIVE, livePrefix: '/live' };
    expect(conflictSentence(aReplay(moved))).toBe(
      'Live records of these topics are moved below /live.',
    );
    expect(conflictSentence(aReplay({ isGhost: true }))).toBe('');
  });

  it('name the clients that are muted, when they are known', () => {
    expect(bannerSentence(aReplay(), ['Mara’s phone', 'Studio cam'])).toBe(
      'This recording is playing into live topics. Mara’s phone and Studio cam are muted until you stop.',
    );
    expect(bannerSentence(aReplay(), ['modules of the master'])).toMatch(
      /Modules of the master are muted/,
    );
    expect(bannerSentence(aReplay(), [])).toMatch(/Live records of these topics are muted/);
    expect(listed(['a', 'b', 'c', 'd', 'e'])).toBe('a, b, c and 2 other clients');
  });
});
