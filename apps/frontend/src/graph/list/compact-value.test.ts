import { expect, it } from 'vitest';
import { compactValue } from './compact-value.ts';

it('writes a colour and a vector of four with one decimal', () => {
  const color = { format: 'color', value: { r: 0.54, g: 0.08, b: 0.74, a: 1 } } as const;
  expect(compactValue(color, '0.54, 0.08, 0.74, 1.00')).toBe('0.5 0.1 0.7 1.0');
  const vector = { format: 'vector4', value: { x: -120.25, y: 3, z: 0.04, w: 1 } } as const;
  expect(compactValue(vector, '−120.25, 3.00, 0.04, 1.00')).toBe('−120.3 3.0 0.0 1.0');
});

it('leaves what fits, and what is no list of numbers', () => {
  const place = { format: 'vector2', value: { x: 0.7, y: 0.4 } } as const;
  expect(compactValue(place, '0.700, 0.400')).toBe('0.700, 0.400');
  const turn = { format: 'quaternion', value: { x: 0, y: 0, z: 0, w: 1 } } as const;
  expect(compactValue(turn, 'x 0.00 y 0.00 z 0.00 w 1.00')).toBe('x 0.00 y 0.00 z 0.00 w 1.00');
  const words = 'a sentence that is longer than the row';
  expect(compactValue({ format: 'string', value: words }, words)).toBe(words);
});
