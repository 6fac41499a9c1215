import { expect, test } from 'vitest';
import { AT_REST } from '../game.ts';
import { templateGame } from './template-game.ts';

const start = () => templateGame.start({ seats: [3, 5], seed: 2 });

test('a player that touches the apple has found it, and the next one is hidden elsewhere', () => {
  const state = start();
  Object.assign(state.runners[1]!.position, state.apple);
  const before = { ...state.apple };
  templateGame.step(state, () => AT_REST, templateGame.settings);
  expect(templateGame.places(state)).toEqual([[5], [3]]);
  expect(state.apple).not.toEqual(before);
  expect(templateGame.feedback(state, 5)).toMatchObject({ place: 1, hitAt: 1 });
  expect(templateGame.hud(state, (seat) => `P${seat}`).news?.sentence).toBe('P5 finds it');
});

test('a runner is faster until the breath is used up', () => {
  const state = start();
  Object.assign(state.apple, { x: 9, y: 9 });
  const [runner, walker] = state.runners;
  const xOf = [runner!.position.x, walker!.position.x];
  const controls = (seat: number) => ({ x: -0.1, y: 0, isPressed: seat === 3 });
  for (let step = 0; step < 30; step += 1) templateGame.step(state, controls, { speed: 1 });
  expect(xOf[0]! - runner!.position.x).toBeCloseTo(2 * (xOf[1]! - walker!.position.x));
  for (let step = 0; step < 60; step += 1) templateGame.step(state, controls, { speed: 1 });
  expect(runner!.breath).toBeLessThan(0.1);
});
