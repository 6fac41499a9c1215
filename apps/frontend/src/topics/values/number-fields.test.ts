import { expect, it } from 'vitest';
import { MAX_FIELDS, numberFields, partsOf, readable, readNumber } from './number-fields.ts';

it('finds numbers and bools by their paths', () => {
  const pose = { position: { x: 1, y: 2 }, name: 'a', on: true, data: new Uint8Array(9) };
  expect(numberFields('pose2D', pose)).toEqual(['position.x', 'position.y', 'on']);
  expect(numberFields('double', 1)).toEqual(['']);
  expect(numberFields('string', '{"a":[1,{"b":2}]}')).toEqual(['a.0', 'a.1.b']);
  expect(numberFields('string', 'hello')).toEqual([]);
  expect(numberFields('string', '{broken')).toEqual([]);
});

it('is bounded, whatever the value holds', () => {
  const wide = Object.fromEntries(Array.from({ length: 500 }, (_, i) => [`n${i}`, i]));
  expect(numberFields('string', JSON.stringify(wide))).toHaveLength(MAX_FIELDS);
  let deep: unknown = 1;
  for (let i = 0; i < 100; i++) deep = { deep };
  expect(numberFields('string', JSON.stringify(deep))).toEqual([]);
});

it('reads only what a value has itself', () => {
  expect(readNumber({ a: { b: 3 } }, partsOf('a.b'))).toBe(3);
  expect(readNumber(true, [])).toBe(1);
  for (const path of ['a', 'a.b.c', 'constructor', '__proto__.x', 'a.toString']) {
    expect(readNumber({ a: { b: 3 } }, partsOf(path)), path).toBeNaN();
  }
  expect(readable('string', '7')).toBe(7);
});
