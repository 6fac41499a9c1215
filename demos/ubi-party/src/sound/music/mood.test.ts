import { expect, test } from 'vitest';
import { EMPTY_ROOM, GAMES, type Room } from '../../sim/index.ts';
import { moodOf } from './mood.ts';

const playing = (game: string): Room => ({ ...EMPTY_ROOM, phase: 'play', games: [game] });
const setup = { seats: [0, 1, 2], seed: 3 };

test('the lobby and the explanation have the music of the lobby, the countdown has none', () => {
  expect(moodOf(EMPTY_ROOM, undefined)).toEqual({ kind: 'lobby' });
  expect(moodOf({ ...EMPTY_ROOM, phase: 'explanation' }, undefined)).toEqual({ kind: 'lobby' });
  expect(moodOf({ ...EMPTY_ROOM, phase: 'countdown' }, undefined)).toBeUndefined();
});

test('the last lap begins with the leader', () => {
  const state = GAMES.race.start(setup);
  expect(moodOf(playing('race'), state)).toEqual({ kind: 'race', isLastLap: false });
  state.carts[1]!.distance = 1e5;
  expect(moodOf(playing('race'), state)).toEqual({ kind: 'race', isLastLap: true });
});

test('the hill counts who is out', () => {
  const state = GAMES.hill.start(setup);
  state.pieces[2]!.outAt = 90;
  expect(moodOf(playing('hill'), state)).toEqual({ kind: 'hill', players: 3, out: 1 });
  expect(moodOf(playing('hill'), undefined)).toEqual({ kind: 'hill', players: 0, out: 0 });
});

test('a game that is not known has music, too', () => {
  expect(moodOf(playing('quiz'), undefined)).toEqual({ kind: 'table' });
});

test('the podium follows the winner of the round, the end that of the tournament', () => {
  const results = [{ game: 'race', places: [[4], [2]], points: { 4: 10, 2: 8 } }];
  const players = [2, 4].map((seat) => ({
    ...{ seat, name: 'P', isReady: true, isWaiting: false, points: seat === 2 ? 30 : 20 },
  }));
  const room: Room = { ...EMPTY_ROOM, phase: 'podium', results, players };
  expect(moodOf(room, undefined)).toEqual({ kind: 'podium', winner: 4 });
  expect(moodOf({ ...room, phase: 'end' }, undefined)).toEqual({ kind: 'podium', winner: 2 });
});
