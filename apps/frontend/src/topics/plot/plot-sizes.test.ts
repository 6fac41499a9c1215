import { expect, it } from 'vitest';
import { PlotSizes } from './plot-sizes.ts';

it('widens an axis for long numbers', () => {
  const sizes = new PlotSizes(7);
  expect(sizes.axis('y1', ['0', '1'])).toBe(48);
  expect(sizes.axis('y1', ['−0.00025', '0.00000'])).toBeGreaterThanOrEqual(8 * 7 + 10);
});

it('does not move when a digit comes and goes', () => {
  const sizes = new PlotSizes(7);
  const wide = sizes.axis('y1', ['−1000.5']);
  expect(sizes.axis('y1', ['1000.5'])).toBe(wide);
  expect(sizes.axis('y1', ['1'])).toBeLessThan(wide);
  sizes.fitLabels(7, true);
  const { right } = sizes;
  sizes.fitLabels(6, true);
  expect(sizes.right).toBe(right);
});
