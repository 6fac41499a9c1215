import { describe, expect, it } from 'vitest';
import { EMPTY_ROOM, type Player, type Room } from '../../sim/index.ts';
import { podiumTable, teamTable } from './podium-table.ts';

const player = (seat: number, points: number): Player => ({
  seat,
  key: `k${seat}`,
  name: `P${seat}`,
  isReady: false,
  isWaiting: false,
  points,
});
const room: Room = {
  ...EMPTY_ROOM,
  phase: 'podium',
  players: [player(0, 14), player(1, 18), player(2, 14), player(3, 3)],
  results: [
    { game: 'race', places: [[0], [1], [2]], points: { 0: 10, 1: 8, 2: 6 } },
    { game: 'hill', places: [[1], [2], [0], [3]], points: { 0: 4, 1: 10, 2: 8, 3: 3 } },
  ],
};

describe('the table of a tournament', () => {
  it('has the best first, shares places, and shows who won and lost places', () => {
    const rows = podiumTable(room);
    expect(rows.map(({ seat, place }) => [seat, place])).toEqual([
      [1, 1],
      [0, 2],
      [2, 2],
      [3, 4],
    ]);
    expect(rows.map(({ moved }) => moved)).toEqual([1, -1, 1, 0]);
    expect(rows.map(({ isWinner }) => isWinner)).toEqual([true, false, false, false]);
  });

  it('leaves a round empty for who did not play it', () => {
    expect(podiumTable(room)[3]?.rounds).toEqual([undefined, 3]);
  });

  it('shows no moves after the first round', () => {
    const first = { ...room, results: room.results.slice(0, 1) };
    expect(podiumTable(first).every(({ moved }) => moved === 0)).toBe(true);
  });

  it('sums up teams', () => {
    expect(teamTable({ ...room, teams: 2 })).toEqual([
      { team: 0, points: 28 },
      { team: 1, points: 21 },
    ]);
    expect(teamTable(room)).toEqual([]);
  });
});
