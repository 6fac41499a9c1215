import { describe, expect, test } from 'vitest';
import type { RoomView } from '../net/index.ts';
import { EMPTY_ROOM, GAMES, type Hud, type Player, type Room } from '../sim/index.ts';
import { playWithBots } from '../sim/testing/play-with-bots.ts';
import { pitchOf } from './note.ts';
import {
  hudEvents,
  countEvents,
  roomEvents,
  stateEvents,
  type SoundEvent,
} from './sound-events.ts';
import { notesOf } from './sound-engine.ts';

const player = (seat: number, more: Partial<Player> = {}): Player => ({
  seat,
  key: `k${seat}`,
  name: 'P',
  isReady: false,
  isWaiting: false,
  points: 0,
  ...more,
});
const view = (room: Partial<Room>): RoomView => ({
  hostId: 'host',
  lags: {},
  room: { ...EMPTY_ROOM, ...room },
});

describe('the room', () => {
  test('is silent about what was there when the page was opened', () => {
    expect(roomEvents(undefined, view({ players: [player(0)] }))).toEqual([]);
  });

  test('is heard when players join, are ready and leave', () => {
    const before = view({ players: [player(0), player(1)] });
    const after = view({ players: [player(1, { isReady: true }), player(5)] });
    expect(roomEvents(before, after)).toEqual([
      { kind: 'ready', seat: 1 },
      { kind: 'join', seat: 5 },
      { kind: 'leave', seat: 0 },
    ]);
    expect(roomEvents(after, after)).toEqual([]);
  });

  test('greets each winner', () => {
    const results = [{ game: 'race', places: [[4, 2], [1]], points: {} }];
    expect(roomEvents(view({ phase: 'play' }), view({ phase: 'podium', results }))).toEqual([
      { kind: 'flourish', seat: 4 },
      { kind: 'flourish', seat: 2 },
    ]);
  });

  test('counts 3, 2, 1 once each', () => {
    const heard = [undefined, 4, 3, 3, 2, 1, 0, undefined].map((left, index, all) =>
      countEvents(all[index - 1], left),
    );
    expect(heard.flat()).toEqual([3, 2, 1].map((left) => ({ kind: 'count', left })));
  });
});

describe('the hud', () => {
  const hud = (more: Partial<Hud>): Hud => ({ headline: '', notes: {}, out: [], ...more });

  test('falls are heard, without the news of them', () => {
    const news = { seat: 3, sentence: 'P3 falls' };
    expect(hudEvents(hud({}), hud({ out: [3], news }))).toEqual([{ kind: 'fall', seat: 3 }]);
    expect(hudEvents(hud({ out: [3], news }), hud({ out: [3], news }))).toEqual([]);
  });

  test('news are heard once', () => {
    const news = { seat: 1, sentence: 'P1 wins' };
    expect(hudEvents(hud({}), hud({ news }))).toEqual([{ kind: 'news', seat: 1 }]);
    expect(hudEvents(hud({ news }), hud({ news }))).toEqual([]);
  });

  test('numbers that count down tick, also from 3 when they appear then', () => {
    const corner = (value: string): Hud => hud({ corner: { value, label: 'seconds left' } });
    expect(hudEvents(hud({}), corner('20'))).toEqual([]);
    expect(hudEvents(corner('20'), corner('19'))).toEqual([{ kind: 'tick', left: 19 }]);
    expect(hudEvents(corner('19'), corner('19'))).toEqual([]);
    expect(hudEvents(hud({}), corner('3'))).toEqual([{ kind: 'tick', left: 3 }]);
    expect(hudEvents(corner('3'), corner('9'))).toEqual([]);
  });
});

/** The sound events of a whole round of bots. */
function heardOf(id: 'race' | 'hill' | 'duel' | 'quiz'): SoundEvent['kind'][] {
  const heard: SoundEvent[] = [];
  let before: { state: unknown; hud: Hud } | undefined;
  playWithBots<unknown, never>(GAMES[id] as never, 6, 4, (now) => {
    const state: unknown = structuredClone(now);
    const hud = GAMES[id].hud(state as never, String);
    if (before) heard.push(...stateEvents(id, before.state, state), ...hudEvents(before.hud, hud));
    before = { state, hud };
  });
  return heard.map(({ kind }) => kind);
}
const count = (kinds: readonly string[], kind: string): number =>
  kinds.filter((one) => one === kind).length;

describe('rounds of bots', () => {
  test('the hill has hits, a crown, falls of all but the last, and each ring', () => {
    const kinds = heardOf('hill');
    expect(count(kinds, 'hit')).toBeGreaterThan(3);
    expect(count(kinds, 'crown')).toBeGreaterThan(0);
    expect(count(kinds, 'fall')).toBeGreaterThanOrEqual(4);
    expect(count(kinds, 'ring')).toBeLessThanOrEqual(4);
  });

  test('the race has boosts, and ticks when the first has finished', () => {
    const kinds = heardOf('race');
    expect(count(kinds, 'boost')).toBeGreaterThan(5);
    expect(count(kinds, 'news')).toBeGreaterThan(0);
  });

  test('the duel has one drum for each flag', () => {
    const kinds = heardOf('duel');
    expect(count(kinds, 'flag')).toBeGreaterThanOrEqual(5);
    expect(count(kinds, 'flag')).toBeLessThanOrEqual(8);
    expect(count(kinds, 'press')).toBe(count(kinds, 'flag') * 6);
  });

  test('the quiz has a mallet for each new statement, and ticks', () => {
    const kinds = heardOf('quiz');
    expect(count(kinds, 'question')).toBe(6);
    expect(count(kinds, 'tick')).toBe(7 * 8);
  });
});

test('pieces knock in the pitch of their player', () => {
  for (const kind of ['join', 'hit', 'news'] as const)
    expect(notesOf({ kind, seat: 7 })[0]!.midi).toBe(pitchOf(7));
});
