import { expect, it } from 'vitest';
import { placeOnPad, valueOnPad } from './pad-area.ts';

it('maps the corners of a surface, y down', () => {
  expect(valueOnPad({ x: 0.25, y: 1.5 }, 'surface')).toEqual({ x: 0.25, y: 1 });
  expect(placeOnPad({ x: -3, y: 0.5 }, 'surface')).toEqual({ x: 0, y: 0.5 });
});

it('maps values around 0, y up, and back', () => {
  const area = { bound: 10 };
  expect(valueOnPad({ x: 1, y: 0 }, area)).toEqual({ x: 10, y: 10 });
  expect(valueOnPad({ x: 0.5, y: 0.5 }, area)).toEqual({ x: 0, y: 0 });
  expect(placeOnPad({ x: -5, y: 5 }, area)).toEqual({ x: 0.25, y: 0.25 });
});
