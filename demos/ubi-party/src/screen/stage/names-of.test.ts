import { expect, it } from 'vitest';
import { EMPTY_ROOM, type Player, type Room } from '../../sim/index.ts';
import { namesOf } from './names-of.ts';

const room = (count: number, phase: Room['phase'] = 'lobby'): Room => ({
  ...EMPTY_ROOM,
  phase,
  players: Array.from({ length: count }, (_, seat): Player => ({
    ...{ seat, name: `P${seat}`, isReady: false, isWaiting: false, points: 0 },
    ...(seat < 3 && { key: `client-${seat}` }),
  })),
});

it('all have names in the lobby, in a crowd people only, during play nobody', () => {
  expect(namesOf(room(18)).size).toBe(18);
  expect([...namesOf(room(32)).keys()]).toEqual([0, 1, 2]);
  expect(namesOf(room(4, 'play')).size).toBe(0);
});
