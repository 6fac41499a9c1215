import { expect, test } from 'vitest';

import { Playhead, type Tune } from './playhead.ts';

const note = { voice: 'knock', midi: 60, strength: 1 } as const;
const tune = (bpm: number, id = 'a'): Tune => ({
  id,
  bpm,
  beats: 2,
  notes: [
    { at: 0, ...note },
    { at: 1, ...note },
  ],
});
const times = (taken: ReturnType<Playhead['take']>): number[] =>
  taken.map(({ atS }) => Math.round(atS * 1000) / 1000);

test('notes come at the tempo of the tune, each once', () => {
  const head = new Playhead();
  head.play(tune(120), 10);
  expect(times(head.take(10, 10.6))).toEqual([10, 10.5]);
  expect(times(head.take(10.3, 10.9))).toEqual([]);
  expect(times(head.take(10.9, 11.6))).toEqual([11, 11.5]);
});

test('a tune that becomes faster goes on at its beat', () => {
  const head = new Playhead();
  head.play(tune(60), 0);
  expect(times(head.take(0, 1.5))).toEqual([0, 1]);
  head.play(tune(120), 1.2);
  // Half a beat is left after 1.5 s, which takes 0.25 s now
  expect(times(head.take(1.2, 2.5))).toEqual([1.75, 2.25]);
});

test('another tune begins now, and none is silence', () => {
  const head = new Playhead();
  head.play(tune(60), 0);
  head.take(0, 0.5);
  head.play(tune(60, 'b'), 0.7);
  expect(times(head.take(0.7, 1.8))).toEqual([0.7, 1.7]);
  head.play(undefined, 2);
  expect(head.take(2, 9)).toEqual([]);
});

test('what is too late is left out', () => {
  const head = new Playhead();
  head.play(tune(60), 0);
  expect(times(head.take(5.5, 7.5))).toEqual([6, 7]);
});
