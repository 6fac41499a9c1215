import { describe, expect, test } from 'vitest';

import { EMPTY_ROOM, GAMES, type Room } from '../sim/index.ts';
import { pitchOf } from './note.ts';
import { notesBetween } from './playhead.ts';
import { tuneOf, moodOf, type Mood } from './tunes.ts';

const MOODS: Mood[] = [
  ...(['lobby', 'duel', 'hunt', 'table'] as const).map((kind) => ({ kind })),
  { kind: 'race', isLastLap: false },
  { kind: 'race', isLastLap: true },
  { kind: 'hill', players: 32, out: 31 },
  { kind: 'podium', winner: 31 },
];

test.each(MOODS)('the tune of $kind lies within its beats and is soft', (mood) => {
  const { notes, beats, bpm } = tuneOf(mood);
  expect(bpm).toBeGreaterThan(0);
  for (const { at, midi, strength } of notes) {
    expect(at >= 0 && at < beats && midi >= 24 && midi <= 100).toBe(true);
    expect(strength > 0 && strength <= 0.8).toBe(true);
  }
});

test('the race is played at 120 bpm, and faster on the last lap, as one tune', () => {
  const [first, last] = [false, true].map((isLastLap) => tuneOf({ kind: 'race', isLastLap }));
  expect(first!.bpm).toBe(120);
  expect(last!.bpm).toBeGreaterThan(120);
  expect(last!.id).toBe(first!.id);
});

describe('the drum of the hill', () => {
  const loudBars = (players: number, out: number): number => {
    const { notes, beats } = tuneOf({ kind: 'hill', players, out });
    const bars = Array.from({ length: beats / 4 }, (_, bar) =>
      Math.max(...notes.filter(({ at }) => Math.floor(at / 4) === bar).map((one) => one.strength)),
    );
    return bars.filter((strength) => strength > 0.5).length;
  };

  test('has one quiet bar more for each player who is out', () => {
    expect([0, 1, 2, 4].map((out) => loudBars(5, out))).toEqual([5, 4, 3, 1]);
  });

  test('has eight bars for more players', () => {
    expect([0, 4, 32].map((out) => loudBars(32, out))).toEqual([8, 7, 0]);
  });
});

test('the marimba of the podium begins with the pitch of the winner', () => {
  for (const winner of [0, 3, 4]) {
    const [first] = tuneOf({ kind: 'podium', winner }).notes;
    expect(first).toMatchObject({ voice: 'marimba', midi: pitchOf(winner) });
  }
  expect(tuneOf({ kind: 'podium', winner: 13 }).notes[0]!.midi % 12).toBe(pitchOf(13) % 12);
});

test('windows that follow each other have each note once, over repetitions', () => {
  const tune = tuneOf({ kind: 'hunt' });
  const whole = notesBetween(tune, 0, 24);
  expect(whole).toHaveLength(tune.notes.length * 3);
  const pieces = Array.from({ length: 80 }, (_, i) => notesBetween(tune, i * 0.3, (i + 1) * 0.3));
  expect(pieces.flat().map(({ beat }) => beat)).toEqual(whole.map(({ beat }) => beat));
});

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
    seat,
    name: 'P',
    isReady: true,
    isWaiting: false,
    points: seat === 2 ? 30 : 20,
  }));
  const room: Room = { ...EMPTY_ROOM, phase: 'podium', results, players };
  expect(moodOf(room, undefined)).toEqual({ kind: 'podium', winner: 4 });
  expect(moodOf({ ...room, phase: 'end' }, undefined)).toEqual({ kind: 'podium', winner: 2 });
});
