import { expect, test } from 'vitest';
import { AT_REST, type Controls } from '../game.ts';
import { quizGame, type QuizState } from './quiz-game.ts';
import { STATEMENTS } from './statements.ts';

const RIGHT_ANSWER = (state: QuizState): number => (STATEMENTS[state.asked[0]!]![1] ? 1 : -1);
const steer = (x: number, isPressed = false): Controls => ({ x, y: 0, isPressed });

/** Plays the first question to the end of its time. */
function firstQuestion(controls: (state: QuizState, seat: number) => Controls): QuizState {
  const state = quizGame.start({ seats: [0, 1, 2], seed: 11 });
  for (let step = 0; step < 9 * 60; step += 1)
    quizGame.step(state, (seat) => controls(state, seat), quizGame.settings);
  return state;
}

test('statements are enough, of both kinds, each once, short, and whole sentences', () => {
  expect(STATEMENTS.length).toBeGreaterThanOrEqual(40);
  expect(new Set(STATEMENTS.map(([text]) => text)).size).toBe(STATEMENTS.length);
  for (const isTrue of [true, false])
    expect(STATEMENTS.filter((one) => one[1] === isTrue).length).toBeGreaterThan(15);
  for (const [text] of STATEMENTS) expect(text).toMatch(/^[A-Z][^.]{5,68}\.$/);
});

test('seven different statements are asked, other ones with another seed', () => {
  const asked = (seed: number): readonly number[] => quizGame.start({ seats: [0], seed }).asked;
  expect(new Set(asked(1)).size).toBe(7);
  expect(asked(2)).not.toEqual(asked(1));
});

test('right answers score, quicker ones more, wrong and missing answers nothing', () => {
  const state = firstQuestion((now, seat) => {
    if (seat === 0) return steer(RIGHT_ANSWER(now));
    return seat === 1 && now.step > 300 ? steer(RIGHT_ANSWER(now)) : AT_REST;
  });
  const [quick, slow, none] = state.answerers.map(({ score }) => score);
  expect(slow).toBeGreaterThanOrEqual(100);
  expect(quick).toBeGreaterThan(slow!);
  expect(quick).toBeLessThanOrEqual(140);
  expect(none).toBe(0);
  expect(quizGame.places(state)).toEqual([[0], [1], [2]]);
});

test('a player who changes to the right side in time is right', () => {
  const state = firstQuestion((now) => steer((now.step < 200 ? -1 : 1) * RIGHT_ANSWER(now)));
  expect(state.answerers.every(({ won }) => won >= 100)).toBe(true);
});

test('the button brings the piece back to the middle', () => {
  const state = firstQuestion((now) => steer(1, now.step > 200));
  for (const { x } of state.answerers) expect(x).toBeCloseTo(0);
});

test('the statement stands on the screen and on the phone, the answer after the time', () => {
  const state = quizGame.start({ seats: [0, 1], seed: 11 });
  const [text, isTrue] = STATEMENTS[state.asked[0]!]!;
  expect(quizGame.hud(state, String).question?.text).toBe(text);
  expect(quizGame.feedback(state, 0).sentence).toBe(text);
  const after = firstQuestion(() => AT_REST);
  expect(quizGame.hud(after, String).headline).toBe(isTrue ? 'It’s true' : 'It’s false');
  expect(quizGame.feedback(after, 0)).toMatchObject({ headline: 'Wrong', hitAt: after.step });
});

test('the phone is told the seconds that are left to answer, and none with the result', () => {
  const state = quizGame.start({ seats: [0], seed: 11 });
  quizGame.step(state, () => AT_REST, quizGame.settings);
  expect(quizGame.feedback(state, 0).secondsLeft).toBe(9);
  expect(
    quizGame.feedback(
      firstQuestion(() => AT_REST),
      0,
    ),
  ).not.toHaveProperty('secondsLeft');
});
