import {
  gameOf,
  lapOf,
  trackOf,
  type Seat,
  type HillState,
  type RaceState,
  type Room,
} from '../sim/index.ts';
import { pitchOf, scalePitch, type Voice } from './note.ts';
import type { Tune, TuneNote } from './playhead.ts';

/** Moods that select the music. */
export type Mood =
  | { readonly kind: 'lobby' | 'duel' | 'hunt' | 'table' }
  | { readonly kind: 'race'; readonly isLastLap: boolean }
  | { readonly kind: 'hill'; readonly players: number; readonly out: number }
  | { readonly kind: 'podium'; readonly winner: Seat };

export function tuneOf(mood: Mood): Tune {
  switch (mood.kind) {
    case 'race':
      return { ...RACE, bpm: mood.isLastLap ? 138 : 120 };
    case 'hill':
      return hillTune(mood.players, mood.out);
    case 'podium':
      return podiumTune(mood.winner);
    default:
      return TUNES[mood.kind];
  }
}

/** One note for each number; a gap is `undefined`. @param every beats from one to the next */
function line(
  voice: Voice,
  strength: number,
  every: number,
  midis: readonly (number | undefined)[],
): TuneNote[] {
  return midis.flatMap((midi, index) =>
    midi === undefined ? [] : { at: index * every, voice, midi, strength },
  );
}

const repeated = <T>(count: number, values: readonly T[]): T[] =>
  Array.from({ length: count }, () => values).flat();

/** Degrees of the pentatonic scale from C4; quiet, with room for the knocks of those who join. */
const LOBBY_DEGREES = [
  ...[0, undefined, 2, 4, undefined, 3, undefined, 1],
  ...[undefined, 2, undefined, 5, 4, undefined, 2, undefined],
  ...[-2, undefined, 1, 3, undefined, 2, undefined, 0],
  ...[undefined, 1, undefined, 4, 3, undefined, undefined, undefined],
];
const C4 = 60;
const C2 = 36;
const _ = undefined;

const LOBBY: Tune = {
  id: 'lobby',
  bpm: 92,
  beats: 16,
  notes: [
    ...line(
      'marimba',
      0.32,
      0.5,
      LOBBY_DEGREES.map((degree) => (degree === _ ? _ : scalePitch(C4, degree))),
    ),
    ...line('bass', 0.22, 4, [C2, C2 + 9, C2 + 5, C2 + 7]),
  ],
};

/** A walking bass, C Am F G, and brushes: soft eighths, the second and fourth beat swept. */
const RACE: Omit<Tune, 'bpm'> = {
  id: 'race',
  beats: 16,
  notes: [
    ...line('bass', 0.6, 1, [
      ...[C2, C2 + 4, C2 + 7, C2 + 9],
      ...[C2 + 9, C2 + 7, C2 + 4, C2 + 2],
      ...[C2 + 5, C2 + 9, C2 + 12, C2 + 9],
      ...[C2 + 7, C2 + 5, C2 + 4, C2 + 2],
    ]),
    ...line('brush', 0.18, 0.5, repeated(32, [C4])),
    ...line('brush', 0.5, 1, repeated(8, [_, C4])),
    ...line('marble', 0.12, 1, repeated(4, [_, _, _, 84])),
  ],
};

const HILL_BARS = 8;
const HILL_BEATS = [0, 1.5, 2, 3, 3.5] as const;
const HILL_STRENGTHS = [0.8, 0.35, 0.6, 0.4, 0.3] as const;
const QUIET = 0.22;

/** A felt drum, one bar for each player up to eight; the last bars are quiet, one for each player that is out. */
function hillTune(players: number, out: number): Tune {
  const bars = Math.min(HILL_BARS, Math.max(2, players));
  const quiet = Math.ceil((out * bars) / Math.max(1, players));
  return {
    id: 'hill',
    bpm: 104,
    beats: bars * 4,
    notes: Array.from({ length: bars }, (__, bar) =>
      HILL_BEATS.map((beat, index): TuneNote => {
        const share = bar >= bars - quiet ? QUIET : 1;
        const strength = HILL_STRENGTHS[index]! * share;
        return { at: bar * 4 + beat, voice: 'felt', midi: index === 0 ? 38 : 43, strength };
      }),
    ).flat(),
  };
}

/** Up and back on the scale of the winner's pitch. */
function podiumTune(winner: Seat): Tune {
  const root = pitchOf(winner);
  // High pitches are an octave lower, so that the tune above them stays warm
  const low = root >= C4 + 24 ? root - 24 : root >= C4 + 12 ? root - 12 : root;
  const degrees = [0, 2, 4, 5, _, 4, 2, _, 3, _, 5, 7, _, 5, 3, _];
  return {
    id: `podium ${winner}`,
    bpm: 104,
    beats: 8,
    notes: [
      ...line(
        'marimba',
        0.5,
        0.5,
        degrees.map((degree) => (degree === _ ? _ : scalePitch(low, degree))),
      ),
      ...line('bass', 0.4, 2, [low - 24, low - 17, low - 24, low - 17]),
    ],
  };
}

const TUNES: Readonly<Record<'lobby' | 'duel' | 'hunt' | 'table', Tune>> = {
  lobby: LOBBY,
  // Near silence: a heart
  duel: {
    id: 'duel',
    bpm: 50,
    beats: 4,
    notes: [
      { at: 0, voice: 'felt', midi: 33, strength: 0.14 },
      { at: 0.35, voice: 'felt', midi: 33, strength: 0.08 },
    ],
  },
  hunt: {
    id: 'hunt',
    bpm: 96,
    beats: 8,
    notes: [
      ...line('shaker', 0.2, 0.5, repeated(16, [C4])),
      ...line('shaker', 0.4, 2, repeated(4, [C4])),
      ...line('clock', 0.4, 1, repeated(4, [84, 79])),
    ],
  },
  table: {
    id: 'table',
    bpm: 84,
    beats: 16,
    notes: [
      ...line('clock', 0.2, 1, repeated(8, [79, 76])),
      ...line('mallet', 0.28, 2, [C4, C4 + 7, C4 + 4, C4 + 9, C4 - 3, C4 + 4, C4 + 2, C4 + 7]),
    ],
  },
};

/** The current mood of the music; undefined is silence. @param state of the round that is played */
export function moodOf(room: Room, state: unknown): Mood | undefined {
  switch (room.phase) {
    case 'lobby':
    case 'explanation':
      return { kind: 'lobby' };
    case 'countdown':
      return undefined;
    case 'play':
      return moodOfGame(gameOf(room), state);
    case 'podium':
      return { kind: 'podium', winner: room.results.at(-1)?.places[0]?.[0] ?? 0 };
    case 'end':
      return { kind: 'podium', winner: leaderOf(room) };
  }
}

/** The lowest seat of those who have the most points. */
export function leaderOf({ players }: Room): number {
  return [...players].sort((a, b) => b.points - a.points || a.seat - b.seat)[0]?.seat ?? 0;
}

function moodOfGame(game: string | undefined, state: unknown): Mood {
  if (game === 'duel' || game === 'hunt') return { kind: game };
  if (game === 'race') return { kind: game, isLastLap: state !== undefined && isLastLap(state) };
  if (game !== 'hill') return { kind: 'table' };
  const pieces = (state as HillState | undefined)?.pieces ?? [];
  const out = pieces.filter(({ outAt }) => outAt !== undefined).length;
  return { kind: game, players: pieces.length, out };
}

function isLastLap(state: unknown): boolean {
  const race = state as RaceState;
  const track = trackOf(race);
  return race.carts.some((cart) => lapOf(cart, track) === track.laps);
}
