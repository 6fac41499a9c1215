import { expect, test } from 'vitest';
import { AT_REST, STEPS_PER_SECOND, type Controls, type Game } from './game.ts';
import { GAMES, type GameId } from './games.ts';
import { duelGame } from './duel/duel-game.ts';
import { huntGame } from './hunt/hunt-game.ts';
import { quizGame } from './quiz/quiz-game.ts';
import { raceGame } from './race/race-game.ts';

const SEATS = [0, 1];

/** Steps of a round in which nobody does anything. */
function stepsOf(id: GameId, pace: number): number {
  const game = GAMES[id] as Game<unknown>;
  const state = game.start({ seats: SEATS, seed: 4, pace });
  let steps = 0;
  for (; !game.isOver(state); steps += 1) game.step(state, () => AT_REST, game.settings);
  return steps;
}

test.each([1.5, 2])('a quiz at pace %f takes so many times as long', (pace) => {
  const [normal, slow] = [stepsOf('quiz', 1) + 1, stepsOf('quiz', pace) + 1];
  expect(slow / normal).toBeCloseTo(pace);
});

test('a right answer in the added time of a quiz counts', () => {
  const state = quizGame.start({ seats: SEATS, seed: 11, pace: 2 });
  const late = (): Controls =>
    state.step < 15 * STEPS_PER_SECOND ? AT_REST : { x: 1, y: 0, isPressed: false };
  const false_ = (): Controls => ({ ...late(), x: -late().x });
  for (let step = 0; step < 18 * STEPS_PER_SECOND; step += 1)
    quizGame.step(state, (seat) => (seat === 0 ? late() : false_()), quizGame.settings);
  const scores = state.answerers.map(({ score }) => score).sort((a, b) => a - b);
  expect(scores[0]).toBe(0);
  expect(scores[1]).toBeGreaterThanOrEqual(100);
});

test('a press in the added time of a duel wins, and is too late at the normal pace', () => {
  const winnerAt = (pace: number): number | undefined => {
    const state = duelGame.start({ seats: SEATS, seed: 2, pace });
    const pressedAtMs = state.bout.signalAtMs + 2200;
    const controls = (seat: number): Controls => {
      const isPressed = seat === 1 && (state.step * 1000) / STEPS_PER_SECOND >= pressedAtMs;
      return isPressed ? { ...AT_REST, isPressed, pressedAtMs } : AT_REST;
    };
    while (state.decided.length === 0) duelGame.step(state, controls, duelGame.settings);
    return state.decided[0]!.winner;
  };
  expect(winnerAt(2)).toBe(1);
  expect(winnerAt(1)).toBeUndefined();
});

test('a thing of a hunt is hunted longer, on top of what the host has set', () => {
  const timeAt = (pace: number): number => {
    const state = huntGame.start({ seats: SEATS, seed: 2, pace });
    const settings = { ...huntGame.settings, time: 0.5 };
    for (let step = 0; step < 2; step += 1) huntGame.step(state, () => AT_REST, settings);
    return state.hunt!.endsAtMs - state.hunt!.beganAtMs;
  };
  expect([1, 1.5, 2].map(timeAt)).toEqual([15_000, 22_500, 30_000]);
});

test('others have longer after the first of a race', () => {
  const isOverAfter = (seconds: number, pace: number): boolean => {
    const state = raceGame.start({ seats: SEATS, seed: 0, pace });
    state.carts[0]!.finishedAt = 100;
    state.step = 100 + seconds * STEPS_PER_SECOND;
    return raceGame.isOver(state);
  };
  expect([isOverAfter(20, 1), isOverAfter(39, 2), isOverAfter(40, 2)]).toEqual([true, false, true]);
});

test('a round at the normal pace is the same as one that names none', () => {
  for (const game of Object.values(GAMES)) {
    const named = (game as Game<unknown>).start({ seats: SEATS, seed: 7, pace: 1 });
    expect(named).toEqual((game as Game<unknown>).start({ seats: SEATS, seed: 7 }));
  }
});
