import { expect, test } from 'vitest';
import { GAMES } from '../../sim/index.ts';
import { sentWords } from './sent-words.ts';

const { race, hill, duel } = GAMES;

test.each([
  [race, 0, 0, false, 'Straight', 'Boost is not pressed.'],
  [race, -0.4, 0, true, 'Left 40 %', 'Boost is pressed.'],
  [hill, 0, 0, false, 'Middle', 'Dash is not pressed.'],
  [hill, 0.9, 0.1, false, 'Right 91 %', 'Dash is not pressed.'],
  [hill, -0.71, -0.71, true, 'Down left 100 %', 'Dash is pressed.'],
  [hill, 0, 0.5, false, 'Up 50 %', 'Dash is not pressed.'],
  [duel, 0, 0, true, 'Pressed', 'Draw is pressed.'],
])('%o with %f, %f, %s: %s', ({ controller }, x, y, isDown, headline, sentence) => {
  expect(sentWords(controller, { x, y }, isDown)).toEqual({ headline, sentence });
});

test('headlines fit on the phone in every direction', () => {
  for (let angle = 0; angle < 64; angle += 1) {
    const [x, y] = [Math.cos(angle / 10), Math.sin(angle / 10)];
    const { headline } = sentWords(hill.controller, { x, y }, false);
    expect(headline).toMatch(/^[A-Z][a-z]+( [a-z]+)? 100 %$/);
    expect(headline.length).toBeLessThanOrEqual(16);
  }
});
