// @vitest-environment happy-dom
import { EMPTY_ROOM } from '@ubii/party/sim';
import { beforeEach, expect, it } from 'vitest';
import { hostStorage } from './host-memory.ts';

const KEY = 'ubii.party';
const player = { seat: 0, name: 'Ada', isReady: true, isWaiting: false, points: 3 };
const memory = {
  room: {
    ...EMPTY_ROOM,
    players: [{ ...player, key: 'client' }],
    results: [{ game: 'race', places: [[0]], points: { 0: 3 } }],
    settings: { race: { laps: 2 } },
  },
  round: { id: 'r', game: 'race', seed: 1, startsAtMs: 2, seats: [0] },
  sinceMs: 2,
  state: { id: 'r', step: 4, state: { carts: [] }, places: [[0]], isOver: false },
};

beforeEach(() => localStorage.clear());

it('keeps a party over a reload', () => {
  expect(hostStorage.load()).toBeUndefined();
  hostStorage.save(memory);
  expect(hostStorage.load()).toEqual(memory);
});

it('fills in what a party of an earlier version lacks', () => {
  localStorage.setItem(KEY, JSON.stringify({ room: { players: [player] } }));
  expect(hostStorage.load()).toEqual({ room: { ...EMPTY_ROOM, players: [player] } });
});

it('begins again when the storage holds something else', () => {
  for (const text of ['{', '{}', '{"room":{"players":5}}', '{"room":{"phase":"sleep"}}']) {
    localStorage.setItem(KEY, text);
    expect(hostStorage.load(), text).toBeUndefined();
  }
});
