import { expect, it } from 'vitest';
import { ReplayedTopics, type LiveRule } from './replayed-topics.ts';

const rule = (): LiveRule => ({
  ...{ clientIds: new Set<string>(), livePrefix: undefined },
  onLive: () => undefined,
});

it('[RP-24] is active only while a replay plays a topic', () => {
  const replayed = new ReplayedTopics();
  expect(replayed.isActive).toBe(false);
  const [first, second] = [rule(), rule()];
  replayed.add('/a', first, undefined);
  replayed.add('/b', first, undefined);
  replayed.add('/c', second, undefined);
  replayed.remove(first);
  expect(replayed.isActive).toBe(true);
  replayed.remove(second);
  expect(replayed.isActive).toBe(false);
});
