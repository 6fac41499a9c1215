import { expect, test } from 'vitest';

import { MAX_SEATS } from '../seats/identity.ts';
import { KEPT_FOR_MS, cheerOf, MAX_SPECTATORS, whyNoSeat, crowderOf } from './members.ts';
import { nextRoom } from './next-room.ts';
import { EMPTY_ROOM, type Room, type RoomEvent } from './room.ts';

function after(room: Room, ...events: RoomEvent[]): Room {
  return events.reduce((one, event) => nextRoom(one, event, 1000), room);
}
const join = (key: string, name = key): RoomEvent => ({ type: 'join', key, name });
const watch = (key: string, name = key): RoomEvent => ({ type: 'watch', key, name });
const proceed: RoomEvent = { type: 'proceed', by: 'host' };
const pair = after(EMPTY_ROOM, join('ada'), join('bob'));
const watched = after(pair, watch('wim'));
const playing = after(watched, proceed, proceed, proceed);

test('spectators have no seat and do not lead; a party of spectators does not start', () => {
  expect(after(EMPTY_ROOM, watch('wim')).leader).toBeUndefined();
  expect(watched.players).toEqual(pair.players);
  expect(() => after(EMPTY_ROOM, watch('a'), watch('b'), proceed)).toThrow('needs 2 players');
  expect(() => after(watched, { type: 'proceed', by: { key: 'wim' } })).toThrow('ada leads');
});

test('nobody waits for spectators to be ready', () => {
  const explained = after(watched, proceed);
  const isReady = (key: string): RoomEvent => ({ type: 'ready', key, isReady: true });
  expect(after(explained, isReady('ada'), isReady('wim')).phase).toBe('explanation');
  expect(after(explained, isReady('ada'), isReady('bob')).phase).toBe('countdown');
});

test('names of spectators are short, differ, and are not needed', () => {
  const named = after(pair, watch('a', ' '), watch('b', ''), watch('c', 'bob'));
  expect(named.spectators.map(({ name }) => name)).toEqual(['Guest', 'Guest 2', 'bob 2']);
  expect(after(named, watch('a', 'Ann')).spectators).toHaveLength(3);
});

test('spectators watch a game that is locked or full, and get a seat when there is one', () => {
  const people = Array.from({ length: MAX_SEATS }, (_, index) => join(`p${index}`));
  const full = after(EMPTY_ROOM, ...people, watch('wim'));
  expect(whyNoSeat(full)).toBe('All 32 seats are taken.');
  expect(() => after(full, join('wim'))).toThrow('seats are taken');
  const seated = after(full, { type: 'leave', key: 'p7' }, join('wim'));
  expect(seated.spectators).toEqual([]);
  expect(seated.players[7]).toMatchObject({ key: 'wim', name: 'wim' });
  const locked = after(pair, { type: 'lock', by: 'host', on: true }, watch('wim'));
  expect(locked.spectators).toHaveLength(1);
  expect(() => after(locked, join('wim'))).toThrow('locked');
});

test('players with a seat do not watch, and a spectator that takes over a seat stops watching', () => {
  expect(() => after(pair, watch('bob'))).toThrow('Leave it first.');
  const moved = after(watched, { type: 'hand-over', key: 'bob', to: 'wim' });
  expect(moved.players[1]!.key).toBe('wim');
  expect(moved.spectators).toEqual([]);
});

test('spectators are bounded', () => {
  const many = Array.from({ length: MAX_SPECTATORS }, (_, index) => watch(`w${index}`));
  const crowd = after(pair, ...many);
  expect(() => after(crowd, watch('one more'))).toThrow(`limit of ${MAX_SPECTATORS} spectators`);
  expect(after(crowd, watch('w3', 'again')).spectators).toHaveLength(MAX_SPECTATORS);
});

test('spectators leave, are removed by the leader, or time out', () => {
  expect(after(watched, { type: 'leave', key: 'wim' })).toEqual(pair);
  const dismiss = (key: string): RoomEvent => ({ type: 'dismiss', by: { key }, key: 'wim' });
  expect(() => after(watched, dismiss('bob'))).toThrow('ada leads');
  expect(after(watched, dismiss('ada')).spectators).toEqual([]);
  const away = after(watched, { type: 'away', key: 'wim' });
  expect(away.spectators[0]!.awaySinceMs).toBe(1000);
  expect(after(away, { type: 'back', key: 'wim' })).toEqual(watched);
  expect(nextRoom(away, { type: 'time' }, 1000 + KEPT_FOR_MS).spectators).toEqual([]);
});

test('players and spectators cheer while there is something to cheer for, and nobody else', () => {
  expect(cheerOf(playing, 'wim', 'love')).toEqual({ kind: 'love', key: 'wim', name: 'wim' });
  expect(cheerOf(playing, 'bob', 'nice')).toMatchObject({ seat: 1, name: 'bob' });
  expect(cheerOf(playing, 'stranger', 'nice')).toBeUndefined();
  expect(cheerOf(watched, 'wim', 'nice')).toBeUndefined();
  for (const kind of ['boo', '', 'constructor', 'nice '])
    expect(cheerOf(playing, 'wim', kind)).toBeUndefined();
});

/** People by the letter of their address: `a1` and `a2` share one. */
const people = (...keys: string[]) => keys.map((key) => ({ key }));
const addresses = new Map(
  ['a1', 'a2', 'a3', 'b1', 'b2', 'c1'].map((key) => [key, key[0]!] as const),
);

test('the address with most places gives the last one to a new client of another', () => {
  expect(crowderOf(people('a1', 'b1', 'a2', 'a3'), 'c1', addresses)).toBe('a3');
});

test('a place is given first by a person who is away', () => {
  const [first, ...others] = people('a1', 'a2', 'a3');
  const away = { ...first!, awaySinceMs: 1 };
  expect(crowderOf([away, ...others], 'c1', addresses)).toBe('a1');
});

test('an address with one place more gives none: places do not go back and forth', () => {
  expect(crowderOf(people('a1', 'b1'), 'c1', addresses)).toBeUndefined();
  expect(crowderOf(people('a1', 'a2', 'b1'), 'b2', addresses)).toBeUndefined();
  expect(crowderOf(people('a1', 'a2'), 'a3', addresses)).toBeUndefined();
});

test('clients of unknown addresses and bots neither give nor get a place', () => {
  expect(crowderOf(people('a1', 'a2', 'a3'), 'unknown', addresses)).toBeUndefined();
  expect(crowderOf([...people('x', 'y', 'z'), {}, {}], 'c1', addresses)).toBeUndefined();
});
