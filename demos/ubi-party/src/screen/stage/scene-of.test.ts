import { expect, test } from 'vitest';
import type { RoundView } from '../../net/index.ts';
import { EMPTY_ROOM } from '../../sim/index.ts';
import { sceneOf } from './scene-of.ts';

const round = (game: string): RoundView => ({
  ...{ id: game, game, seed: 1, startsAtMs: 0, seats: [0, 1] },
});
const ROOM = { ...EMPTY_ROOM, phase: 'play' } as const;

test('a game with a scene of its own gives its state to it', () => {
  expect(sceneOf(ROOM, round('hill'), undefined)).toMatchObject({ kind: 'hill', state: {} });
});

test('a game without one shows its pieces on the table', () => {
  const scene = sceneOf(ROOM, round('quiz'), undefined);
  expect(scene).toMatchObject({ kind: 'pieces', pieces: [{ seat: 0 }, { seat: 1 }] });
});
