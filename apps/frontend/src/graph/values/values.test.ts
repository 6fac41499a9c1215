import { describe, expect, it } from 'vitest';
import {
  fieldKind,
  hexOf,
  isTypable,
  partsOf,
  valueOf,
  withHex,
  withPart,
} from '../../formats/value-parts.ts';
import { scrubbed, stepOf } from './scrub.ts';

const NO_KEYS = { shiftKey: false, altKey: false };

describe('the fields of values', () => {
  it('follow the data format', () => {
    expect(fieldKind('double')).toBe('number');
    expect(fieldKind('bool')).toBe('switch');
    expect(fieldKind('vector3')).toBe('parts');
    expect(fieldKind('color')).toBe('color');
    expect(fieldKind('pose3D')).toBe('json');
    expect(isTypable('image2D')).toBe(false);
    expect(isTypable('vector2List')).toBe(false);
    expect(isTypable('mouseEvent')).toBe(true);
  });

  it('read and write single members', () => {
    const json = '{"vector2":{"x":1,"y":2}}';
    expect(partsOf('vector2', json)).toEqual([1, 2]);
    expect(withPart('vector2', json, 'y', 5)).toBe('{"vector2":{"x":1,"y":5}}');
    expect(withPart('vector3', undefined, 'z', 1)).toBe('{"vector3":{"x":0,"y":0,"z":1}}');
  });

  it('take what is damaged for nothing', () => {
    expect(valueOf('double', '{')).toBeUndefined();
    expect(partsOf('vector2', 'null')).toEqual([0, 0]);
    expect(partsOf('vector2', '{"vector2":{"x":"a"}}')).toEqual([0, 0]);
  });

  it('show colours as browsers pick them, and keep how opaque they are', () => {
    expect(hexOf([1, 0, 0.5, 1])).toBe('#ff0080');
    const json = withHex('{"color":{"r":0,"g":0,"b":0,"a":0.25}}', '#ff0000');
    expect(JSON.parse(json)).toEqual({ color: { r: 1, g: 0, b: 0, a: 0.25 } });
    expect(partsOf('color', withHex(undefined, '#00ff00'))).toEqual([0, 1, 0, 1]);
  });
});

describe('dragging a number', () => {
  it('goes in steps of its size', () => {
    expect(stepOf(0.35, false, NO_KEYS)).toBeCloseTo(0.01);
    expect(stepOf(1.2, false, NO_KEYS)).toBeCloseTo(0.1);
    expect(stepOf(250, false, NO_KEYS)).toBeCloseTo(10);
    expect(stepOf(7, true, NO_KEYS)).toBe(1);
  });

  it('leaves no noise of binary fractions behind', () => {
    expect(scrubbed(1.2, 9, false, NO_KEYS)).toBe(1.5);
    expect(scrubbed(0, -6, false, NO_KEYS)).toBe(-0.2);
    expect(scrubbed(10, 30, true, NO_KEYS)).toBe(20);
  });

  it('goes further with Shift, and finer with Alt', () => {
    expect(scrubbed(1, 3, false, { shiftKey: true, altKey: false })).toBe(2);
    expect(scrubbed(1, 3, false, { shiftKey: false, altKey: true })).toBe(1.01);
  });
});
