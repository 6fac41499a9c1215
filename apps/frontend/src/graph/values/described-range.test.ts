import { describe, expect, it } from 'vitest';
import { describedRange, stepIn } from './described-range.ts';

describe('the range in a description', () => {
  it.each([
    ['Left edge of the part, 0 to 1 of the width.', 0, 1],
    ['Longest side, 0 to 16 384 pixels; 0 keeps the size.', 0, 16_384],
    ['Side with the black border, 0.001 to 100 m.', 0.001, 100],
    ['Angle, −90 to 90°.', -90, 90],
    ['Frequency of the waves, 0 to 1000 Hz; usable up to half of it.', 0, 1000],
  ])('%s', (description, min, max) => {
    expect(describedRange(description)).toEqual({ min, max });
  });

  it.each(['', 'Pixel format of the output.', 'Time from 3 to 1, downwards.', 'Goes to 5.'])(
    'is unknown in "%s"',
    (description) => expect(describedRange(description)).toBeUndefined(),
  );

  it('has steps that fit it', () => {
    expect([1, 20, 256].map((max) => stepIn({ min: 0, max }))).toEqual([0.01, 0.1, 1]);
  });
});
