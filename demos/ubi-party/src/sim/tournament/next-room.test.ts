import { describe, expect, it } from 'vitest';
import { MAX_SEATS } from '../seats/identity.ts';
import { nextRoom } from './next-room.ts';
import {
  EMPTY_ROOM,
  gameOf,
  teamOf,
  RoomRefusal,
  type Pace,
  type Room,
  type RoomEvent,
} from './room.ts';
import { KEPT_FOR_MS } from './members.ts';

/** A room after some events, a millisecond apart. */
function after(room: Room, ...events: RoomEvent[]): Room {
  return events.reduce((one, event) => nextRoom(one, event, 1000), room);
}
const join = (key: string, name = key): RoomEvent => ({ type: 'join', key, name });
const proceed: RoomEvent = { type: 'proceed', by: 'host' };
const pair = after(EMPTY_ROOM, join('ada'), join('bob'));
const playing = after(pair, proceed, proceed, proceed);

describe('seats', () => {
  it('go to joining players in order; the first one leads', () => {
    expect(pair.players.map(({ seat, name }) => [seat, name])).toEqual([
      [0, 'ada'],
      [1, 'bob'],
    ]);
    expect(pair.leader).toBe(0);
  });

  it('are kept by returning players, with points and place', () => {
    const scored = after(playing, { type: 'round-over', places: [[1], [0]] });
    const back = after(scored, { type: 'away', key: 'bob' }, join('bob'));
    expect(back.players[1]).toMatchObject({ seat: 1, points: 10 });
    expect(back.players[1]!.awaySinceMs).toBeUndefined();
  });

  it('are free again after two minutes, and not before', () => {
    const away = after(pair, { type: 'away', key: 'bob' });
    expect(nextRoom(away, { type: 'time' }, 1000 + KEPT_FOR_MS - 1).players).toHaveLength(2);
    expect(nextRoom(away, { type: 'time' }, 1000 + KEPT_FOR_MS).players).toHaveLength(1);
  });

  it('are handed over to another phone, with all that belongs to them', () => {
    const moved = after(playing, { type: 'hand-over', key: 'bob', to: 'spare' });
    expect(moved.players[1]).toMatchObject({ seat: 1, key: 'spare', name: 'bob' });
    expect(() => after(moved, { type: 'hand-over', key: 'bob', to: 'thief' })).toThrow(RoomRefusal);
    expect(() => after(moved, { type: 'hand-over', key: 'spare', to: 'ada' })).toThrow(
      'has a seat',
    );
  });

  it('are filled with bots, which leave when people come', () => {
    const full = after(pair, { type: 'fill', by: 'host', players: MAX_SEATS });
    expect(full.players).toHaveLength(MAX_SEATS);
    const more = after(full, join('cleo'));
    expect(more.players).toHaveLength(MAX_SEATS);
    expect(more.players[2]).toMatchObject({ key: 'cleo', seat: 2 });
    expect(after(more, { type: 'fill', by: 'host', players: 0 }).players).toHaveLength(3);
  });

  it('have names that are short and differ', () => {
    const named = after(
      EMPTY_ROOM,
      join('a', ' Mara\n'),
      join('b', 'Mara'),
      join('c', 'x'.repeat(99)),
      join('d', ''),
    );
    expect(named.players.map(({ name }) => name)).toEqual(['Mara', 'Mara 2', 'x'.repeat(16), 'D']);
  });

  it('are refused when the game is locked or full', () => {
    const locked = after(pair, { type: 'lock', by: 'host', on: true });
    expect(() => after(locked, join('cleo'))).toThrow('locked');
    expect(after(locked, join('bob')).players).toHaveLength(2);
    const people = Array.from({ length: MAX_SEATS }, (_, index) => join(`p${index}`));
    expect(() => after(EMPTY_ROOM, ...people, join('late'))).toThrow('All 32 seats are taken.');
  });
});

describe('the leader', () => {
  it('is the leader or the big screen alone', () => {
    expect(() => after(pair, { type: 'proceed', by: { key: 'bob' } })).toThrow(
      'ada leads the game.',
    );
    expect(after(pair, { type: 'proceed', by: { key: 'ada' } }).phase).toBe('explanation');
  });

  it('passes on when the leader goes, to a player who is there', () => {
    const three = after(pair, join('cleo'), { type: 'away', key: 'bob' });
    expect(after(three, { type: 'leave', key: 'ada' }).leader).toBe(2);
    expect(after(pair, { type: 'lead', by: { key: 'ada' }, seat: 1 }).leader).toBe(1);
  });

  it('may kick, and bots never lead', () => {
    const kicked = after(
      pair,
      { type: 'fill', by: 'host', players: 3 },
      { type: 'kick', by: 'host', seat: 0 },
    );
    expect(kicked.players.map(({ seat }) => seat)).toEqual([1, 2]);
    expect(kicked.leader).toBe(1);
    expect(() => after(kicked, { type: 'lead', by: 'host', seat: 2 })).toThrow(RoomRefusal);
  });
});

describe('a tournament', () => {
  it('goes from the lobby through every game to the end, and begins again', () => {
    let room = pair;
    for (const game of room.games) {
      room = after(room, proceed);
      expect(room.phase).toBe('explanation');
      expect(gameOf(room)).toBe(game);
      room = after(room, proceed, proceed, { type: 'round-over', places: [[0], [1]] });
      expect(room.phase).toBe('podium');
      expect(gameOf(room)).toBe(game);
    }
    room = after(room, proceed);
    expect(room.phase).toBe('end');
    expect(room.players.map(({ points }) => points)).toEqual([30, 24]);
    expect(after(room, proceed)).toMatchObject({ phase: 'lobby', results: [] });
  });

  it('goes on by itself when the time is over', () => {
    const explained = nextRoom(pair, proceed, 1000);
    expect(nextRoom(explained, { type: 'time' }, 20_999).phase).toBe('explanation');
    expect(nextRoom(explained, { type: 'time' }, 21_000).phase).toBe('countdown');
  });

  it('gives phones the time to load the detector of a hunt, at every pace', () => {
    const hunt: Room = { ...pair, games: ['hunt'] };
    expect(nextRoom(hunt, proceed, 1000).endsAtMs).toBe(61_000);
    const relaxed = nextRoom(
      nextRoom(hunt, proceed, 1000),
      { type: 'set-pace', by: 'host', pace: 'relaxed' },
      9000,
    );
    expect(relaxed.endsAtMs).toBe(91_000);
  });

  it('does not wait for those who are away', () => {
    const explained = after(pair, proceed, { type: 'away', key: 'bob' });
    expect(after(explained, { type: 'ready', key: 'ada', isReady: true }).phase).toBe('countdown');
  });

  it.each([
    { type: 'away', key: 'bob' },
    { type: 'leave', key: 'bob' },
    { type: 'kick', by: 'host', seat: 1 },
  ] as const)('goes on when the last player it waits for is gone: $type', (gone) => {
    const three = after(pair, join('cleo'), proceed);
    const waiting = after(
      three,
      { type: 'ready', key: 'ada', isReady: true },
      { type: 'ready', key: 'cleo', isReady: true },
    );
    expect(waiting.phase).toBe('explanation');
    expect(after(waiting, gone, { type: 'time' }).phase).toBe('countdown');
    expect(after(three, gone, { type: 'time' }).phase).toBe('explanation');
  });

  it('does not hurry through its games when only bots are there', () => {
    const explained = after(pair, { type: 'fill', by: 'host', players: 4 }, proceed);
    const left = after(
      explained,
      { type: 'away', key: 'ada' },
      { type: 'away', key: 'bob' },
      { type: 'time' },
    );
    expect(left.phase).toBe('explanation');
  });

  it('lets late players wait for the next round', () => {
    const late = after(playing, join('cleo'));
    expect(late.players[2]!.isWaiting).toBe(true);
    const next = after(late, { type: 'round-over', places: [[0], [1]] }, proceed);
    expect(next.players[2]!.isWaiting).toBe(false);
  });

  it('needs two, and is changed in the lobby only', () => {
    expect(() => after(EMPTY_ROOM, join('ada'), proceed)).toThrow('needs 2 players');
    expect(() => after(playing, { type: 'set-teams', by: 'host', teams: 2 })).toThrow(
      'in the lobby only',
    );
    expect(() => after(pair, { type: 'set-teams', by: 'host', teams: 1 })).toThrow(
      'no teams, or 2 to 4',
    );
    const teams = after(pair, { type: 'set-teams', by: 'host', teams: 2 });
    expect([0, 1, 2].map((seat) => teamOf(teams, seat))).toEqual([0, 1, 0]);
    expect(teamOf(pair, 0)).toBeUndefined();
  });

  it('gives the points of a place to all who share it', () => {
    const tied = after(playing, join('c'), { type: 'round-over', places: [[0, 1], [2]] });
    expect(tied.players.map(({ points }) => points)).toEqual([10, 10, 6]);
  });

  it('is plain data: stored and read, it goes on', () => {
    expect(JSON.parse(JSON.stringify(playing))).toEqual(playing);
  });
});

describe('settings of games', () => {
  const set = (setting: string, value: number, game = 'hunt'): RoomEvent => ({
    type: 'set-setting',
    by: 'host',
    game,
    setting,
    value,
  });

  it('are kept with the room while they are not as the game is meant', () => {
    const room = after(pair, set('cup', 0), set('time', 2), set('friction', 9, 'hill'));
    expect(room.settings).toEqual({ hunt: { cup: 0, time: 2 }, hill: { friction: 5 } });
    expect(after(room, set('cup', 1), set('time', 1)).settings).toEqual({ hill: { friction: 5 } });
  });

  it.each([
    ['constructor', 1, 'hunt'],
    ['time', 1, 'constructor'],
    ['time', Number.NaN, 'hunt'],
  ])('refuse what is none: %s %f %s', (setting, value, game) => {
    expect(() => after(pair, set(setting, value, game))).toThrow(RoomRefusal);
  });
});

describe('the pace', () => {
  const pace = (to: Pace): RoomEvent => ({ type: 'set-pace', by: 'host', pace: to });

  it('makes explanations and podiums longer, and the countdown not', () => {
    const long = nextRoom(pair, pace('long'), 0);
    const explained = nextRoom(long, proceed, 1000);
    expect(explained.endsAtMs).toBe(1000 + 40_000);
    const counted = nextRoom(explained, proceed, 1000);
    expect(counted.endsAtMs).toBe(1000 + 3000);
    const played = nextRoom(counted, proceed, 1000);
    const over = nextRoom(played, { type: 'round-over', places: [[0], [1]] }, 2000);
    expect(over.endsAtMs).toBe(2000 + 30_000);
  });

  it('changes what is being read, from when it began', () => {
    const explained = nextRoom(pair, proceed, 1000);
    const relaxed = nextRoom(explained, pace('relaxed'), 9000);
    expect(relaxed).toMatchObject({ pace: 'relaxed', endsAtMs: 31_000 });
    expect(nextRoom(relaxed, pace('normal'), 9000).endsAtMs).toBe(21_000);
  });

  it('stays during a round, and is one of three', () => {
    expect(() => after(playing, pace('long'))).toThrow('between rounds');
    expect(() => after(pair, pace('constructor' as Pace))).toThrow(RoomRefusal);
    expect(() => after(pair, { ...pace('long'), by: { key: 'bob' } } as RoomEvent)).toThrow('ada');
  });
});
