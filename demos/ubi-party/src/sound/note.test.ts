import { expect, test } from 'vitest';

import { hzOf, pitchOf, scalePitch } from './note.ts';

test('the first fifteen players have different pitches of one pentatonic scale', () => {
  const pitches = Array.from({ length: 15 }, (_, seat) => pitchOf(seat));
  expect(new Set(pitches).size).toBe(15);
  expect(new Set(pitches.map((pitch) => pitch % 12))).toEqual(new Set([0, 2, 4, 7, 9]));
  expect(pitchOf(31)).toBe(pitchOf(1));
});

test('steps of the scale go over octaves, up and down', () => {
  expect([-1, 0, 4, 5, 6].map((degree) => scalePitch(60, degree))).toEqual([57, 60, 69, 72, 74]);
});

test('an octave is twice the frequency', () => {
  expect([hzOf(69), hzOf(81), hzOf(60)]).toEqual([440, 880, expect.closeTo(261.626, 3)]);
});
