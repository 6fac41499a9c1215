import { expect, test } from 'vitest';

import { ordinal } from '../../sim/index.ts';
import { roomWith } from '../testing/fake-phone-link.ts';
import { lastPlaceOf, placeTable, readiness } from './useStanding.ts';

const ROOM = roomWith(1, ['Theo', 'Ines', 'Sam']);

test('table has the best first, and equal points share a place', () => {
  const points = [3, 8, 3, 1];
  const players = ROOM.players.map((player, at) => ({ ...player, points: points[at]! }));
  expect(placeTable({ ...ROOM, players }).map(({ place, player }) => [place, player.name])).toEqual(
    [
      [1, 'Mara'],
      [2, 'Theo'],
      [2, 'Ines'],
      [4, 'Sam'],
    ],
  );
});

test('place in the newest round is known for those who played it', () => {
  const results = [{ game: 'race', places: [[2, 0], [1]], points: { 0: 5, 1: 2, 2: 5 } }];
  const room = { ...ROOM, results };
  expect([0, 1, 3].map((seat) => lastPlaceOf(room, seat))).toEqual([1, 3, undefined]);
  expect(placeTable(room).map(({ won }) => won)).toEqual([5, 2, 5, undefined]);
});

test('players who are away are not waited for', () => {
  const players = ROOM.players.map((player) => ({
    ...player,
    isReady: player.seat === 1,
    ...(player.seat === 0 && { awaySinceMs: 5 }),
  }));
  expect(readiness({ ...ROOM, players })).toBe('1 of 3 ready');
});

test('places are read aloud as English does', () => {
  expect([1, 2, 3, 4, 11, 12, 13, 21, 22].map(ordinal).join(' ')).toBe(
    '1st 2nd 3rd 4th 11th 12th 13th 21st 22nd',
  );
});
