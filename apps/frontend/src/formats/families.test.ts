import { DATA_FORMATS } from '@ubii/proto';
import { expect, it } from 'vitest';
import { FAMILIES, formatLook } from './families.ts';
import { SOCKET_SHAPES } from './socket-shapes.ts';

it('every data format has a family with a shape of its own, a letter and an icon', () => {
  const families = new Set(Object.values(DATA_FORMATS).map(({ family }) => family));
  for (const family of families) {
    expect(FAMILIES[family].letter, family).toHaveLength(1);
    expect(SOCKET_SHAPES[family].outline, family).not.toBe('');
  }
  const outlines = Object.values(SOCKET_SHAPES).map(({ outline }) => outline);
  expect(new Set(outlines).size).toBe(outlines.length);
  const letters = Object.values(FAMILIES).map(({ letter }) => letter);
  expect(new Set(letters).size).toBe(letters.length);
});

it('reads a format in the spellings that occur, and shows an unknown one as it is', () => {
  expect(formatLook('ubii.dataStructure.Vector2')).toEqual({
    format: 'vector2',
    family: 'vector',
    isList: false,
    text: 'vector2',
  });
  expect(formatLook('vector2List')).toMatchObject({ family: 'vector', isList: true });
  expect(formatLook('my.own.Thing')).toMatchObject({ format: undefined, text: 'my.own.Thing' });
});
