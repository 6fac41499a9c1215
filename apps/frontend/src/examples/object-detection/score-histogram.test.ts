import { expect, it } from 'vitest';
import { SCORE_BARS, ScoreHistogram } from './score-histogram.ts';

it('counts scores of the last ten seconds in bars, rare ones visible beside frequent ones', () => {
  const histogram = new ScoreHistogram();
  for (let count = 0; count < 4; count++) histogram.add([0.1, 1], 0);
  histogram.add([0.5], 9000);
  const heights = histogram.heights(9000);
  expect(heights).toHaveLength(SCORE_BARS);
  expect(heights[SCORE_BARS / 10]).toBe(1);
  expect(heights[SCORE_BARS - 1], 'a score of 1 is in the last bar').toBe(1);
  expect(heights[SCORE_BARS / 2]).toBe(0.5);
  expect(heights[0]).toBe(0);
  expect(histogram.heights(10_500)[SCORE_BARS / 10], 'forgotten').toBe(0);
  expect(histogram.heights(10_500)[SCORE_BARS / 2]).toBe(1);
});

it('takes no scores outside of 0 to 1, and is empty when cleared', () => {
  const histogram = new ScoreHistogram();
  histogram.add([-0.1, 1.1, Number.NaN], 0);
  expect(Math.max(...histogram.heights(0))).toBe(0);
  histogram.add([0.3], 0);
  histogram.clear();
  expect(Math.max(...histogram.heights(0))).toBe(0);
});
