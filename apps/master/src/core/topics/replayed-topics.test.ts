import { expect, it } from 'vitest';
import { liveRule, playFirst } from '../../testing/live-rule.ts';
import { ReplayedTopics } from './replayed-topics.ts';

it('[RP-24] is active only while a replay plays a topic', () => {
  const replayed = new ReplayedTopics();
  expect(replayed.isActive).toBe(false);
  const [first, second] = [liveRule(), liveRule()];
  replayed.add('/a', first);
  replayed.add('/b', first);
  replayed.add('/c', second);
  replayed.remove(first);
  expect(replayed.isActive).toBe(true);
  replayed.remove(second);
  expect(replayed.isActive).toBe(false);
});

it('[RP-20] mutes nothing on a topic before a record of the replay is accepted', () => {
  const replayed = new ReplayedTopics();
  replayed.add('/a', liveRule());
  expect([replayed.has('/a'), replayed.mutes('/a', 'bob')]).toEqual([false, false]);
  playFirst(replayed, '/a');
  expect([replayed.has('/a'), replayed.mutes('/a', 'bob')]).toEqual([true, true]);
});
