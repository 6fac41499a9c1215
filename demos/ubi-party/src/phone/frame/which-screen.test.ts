import { expect, test } from 'vitest';
import { EMPTY_ROOM, PHASES, type Phase, type Player } from '../../sim/index.ts';
import { removalOf, screenOf } from './which-screen.ts';

const ME: Player = {
  seat: 2,
  key: 'a',
  name: 'Mara',
  isReady: false,
  isWaiting: false,
  points: 0,
};

function view(phase: Phase) {
  return { room: { ...EMPTY_ROOM, phase, players: [ME] }, hostId: 'host', lags: {} };
}

test('each phase has its screen for a player', () => {
  expect(PHASES.map((phase) => screenOf({ view: view(phase), me: ME }))).toEqual([
    'lobby',
    'explanation',
    'play',
    'play',
    'result',
    'result',
  ]);
});

test('late joiner waits until the next round', () => {
  const me = { ...ME, isWaiting: true };
  expect(PHASES.map((phase) => screenOf({ view: view(phase), me }))).toEqual([
    'lobby',
    'waiting',
    'waiting',
    'waiting',
    'waiting',
    'result',
  ]);
});

test('phone without a seat joins, or learns why it has none', () => {
  expect(screenOf({ view: undefined, me: undefined })).toBe('join');
  expect(screenOf({ view: view('play'), me: undefined })).toBe('join');
  expect(screenOf({ view: view('play'), me: undefined }, 'removed')).toBe('removed');
});

test('phone without a seat watches in every phase', () => {
  const spectator = { key: 'b', name: 'Wim' };
  for (const phase of PHASES)
    expect(screenOf({ view: view(phase), me: undefined, spectator })).toBe('watch');
});

test('seat that another phone has now was taken over', () => {
  const room = { ...EMPTY_ROOM, players: [{ ...ME, key: 'b' }] };
  expect(removalOf(room, ME, false)).toBe('taken-over');
});

test('seat that is free or has another player was lost', () => {
  expect(removalOf(EMPTY_ROOM, ME, false)).toBe('removed');
  expect(removalOf(EMPTY_ROOM, ME, true)).toBe('timed-out');
  const room = { ...EMPTY_ROOM, players: [{ ...ME, key: 'b', name: 'Theo' }] };
  expect(removalOf(room, ME, false)).toBe('removed');
});
