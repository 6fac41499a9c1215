import { expect, test } from 'vitest';
import { MAX_SEATS } from '../seats/identity.ts';
import { nextRoom } from './next-room.ts';
import { EMPTY_ROOM, type Room } from './room.ts';
import { type RoomEvent } from './room-event.ts';
import { KEPT_FOR_MS } from './seating.ts';
import { cheerOf, MAX_SPECTATORS, whyNoSeat } from './watching.ts';

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
