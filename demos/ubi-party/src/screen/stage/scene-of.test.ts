import { expect, it, describe, test } from 'vitest';

import type { RoundState } from '../../modules/index.ts';
import type { RoundView } from '../../net/index.ts';
import { EMPTY_ROOM, type Player, type Room } from '../../sim/index.ts';
import { namesOf, RoundFilm, sceneOf } from './scene-of.ts';

const room = (count: number, phase: Room['phase'] = 'lobby'): Room => ({
  ...EMPTY_ROOM,
  phase,
  players: Array.from({ length: count }, (_, seat): Player => ({
    seat,
    name: `P${seat}`,
    isReady: false,
    isWaiting: false,
    points: 0,
    ...(seat < 3 && { key: `client-${seat}` }),
  })),
});

it('all have names in the lobby, in a crowd people only, during play nobody', () => {
  expect(namesOf(room(18)).size).toBe(18);
  expect([...namesOf(room(32)).keys()]).toEqual([0, 1, 2]);
  expect(namesOf(room(4, 'play')).size).toBe(0);
});

const frame = (step: number, id = 'a'): RoundState => ({
  id,
  step,
  state: { step },
  places: [],
  isOver: false,
});

describe('the film of a round', () => {
  it('keeps its last four seconds, and plays them slower', () => {
    const film = new RoundFilm();
    for (let step = 1; step <= 1000; step += 1) film.add(frame(step));
    expect(film.newest?.step).toBe(1000);
    expect(film.at(0)?.step).toBe(760);
    expect(film.lengthMs).toBeCloseTo(4000 / 0.6);
    expect(film.at(film.lengthMs)?.step).toBe(1000);
    expect(film.at(film.lengthMs + 1)).toBeUndefined();
  });

  it('begins again with another round', () => {
    const film = new RoundFilm();
    for (let step = 1; step <= 100; step += 1) film.add(frame(step));
    film.add(frame(1, 'b'));
    expect(film.at(0)).toEqual(frame(1, 'b'));
  });

  it('is empty before the first state', () => {
    expect(new RoundFilm().at(0)).toBeUndefined();
  });
});

const round = (game: string): RoundView => ({
  id: game,
  game,
  seed: 1,
  startsAtMs: 0,
  seats: [0, 1],
});
const ROOM = { ...EMPTY_ROOM, phase: 'play' } as const;

test('a game with a scene of its own gives its state to it', () => {
  expect(sceneOf(ROOM, round('hill'), undefined)).toMatchObject({ kind: 'hill', state: {} });
});

test('a game without one shows its pieces on the table', () => {
  const scene = sceneOf(ROOM, round('quiz'), undefined);
  expect(scene).toMatchObject({ kind: 'pieces', pieces: [{ seat: 0 }, { seat: 1 }] });
});
