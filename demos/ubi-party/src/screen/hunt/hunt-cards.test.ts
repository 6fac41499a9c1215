import { describe, expect, it } from 'vitest';
import type { Photo } from '../../net/index.ts';
import type { HuntState, Player } from '../../sim/index.ts';
import { huntCards } from './hunt-cards.ts';

const STARTS_AT_MS = 1_800_000_000_000.25;
const player = (seat: number, name: string, key?: string): Player => ({
  seat,
  name,
  isReady: false,
  isWaiting: false,
  points: 0,
  ...(key !== undefined && { key }),
});
const PLAYERS = [
  player(0, 'Mara', 'm'),
  player(1, 'Theo', 't'),
  player(2, 'Jo', 'j'),
  player(3, 'Bot'),
];
const AREA = { x: 0.1, y: 0.1, width: 0.5, height: 0.5 };
const found = (atMs: number, score = 0.9) => ({
  atMs,
  text: 'cup',
  score,
  verdict: 'found' as const,
});

const state = (photos: NonNullable<HuntState['hunt']>['photos']): HuntState => ({
  step: 600,
  seats: [0, 1, 2, 3],
  hunted: ['cup'],
  points: {},
  wrongAt: {},
  random: [],
  isOver: false,
  hunt: {
    label: 'cup',
    beganAtMs: 0,
    endsAtMs: 30_000,
    isDecisive: false,
    leastScore: 0.4,
    hunters: [0, 1, 2, 3],
    present: [0, 1, 2, 3],
    photos,
  },
});
const photoAt = (atMs: number): Photo => ({
  jpeg: new Uint8Array(3),
  width: 4,
  height: 3,
  atMs: Math.round(STARTS_AT_MS + atMs),
});

describe('the cards on the line', () => {
  it('say who hunts, whose phone looks, and who has found it as which', () => {
    const looking = { atMs: 4000, text: '', score: 0, verdict: 'looking' as const };
    const cards = huntCards(
      state({ 0: found(3000), 1: looking, 3: found(2000, 0.7) }),
      PLAYERS,
      new Map(),
      STARTS_AT_MS,
    );
    expect(cards.map(({ note }) => note)).toEqual(['2nd +2', 'looking', 'hunting', '1st +3']);
    expect(cards.map(({ isBest }) => isBest)).toEqual([true, false, false, false]);
  });

  it('show the photo of this moment only, with what was seen in it', () => {
    const photos = new Map([
      ['m', photoAt(3000)],
      ['t', photoAt(1000)],
    ]);
    const wrong = { atMs: 5000, text: 'bowl', score: 0.88, verdict: 'wrong' as const };
    const [mara, theo] = huntCards(
      state({ 0: { ...found(3000, 0.97), area: AREA }, 1: { ...wrong, area: AREA } }),
      PLAYERS,
      photos,
      STARTS_AT_MS,
    );
    expect(mara).toMatchObject({ photo: photos.get('m'), mark: 'cup 97', area: AREA });
    expect(theo).toMatchObject({ status: 'wrong', note: 'not a cup' });
    expect(theo).not.toHaveProperty('photo');
    expect(theo).not.toHaveProperty('mark');
  });

  it('give the points with that of the best photo when the thing is decided', () => {
    const gains = { 0: { place: 1, points: 4, isBest: true } };
    const decided = { ...state({ 0: found(3000) }), decided: { untilMs: 1, gains } };
    const cards = huntCards(decided, PLAYERS, new Map(), STARTS_AT_MS);
    expect(cards.map(({ note }) => note)).toEqual([
      '1st +4',
      'not found',
      'not found',
      'not found',
    ]);
  });
});
