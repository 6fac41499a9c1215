import { describe, expect, it } from 'vitest';
import { jsonPlaces, placeAt } from './json-places.ts';

const TEXT = `{
  "topic": "/a",
  "pose3D": {
    "position": { "x": 1, "y": "up" }
  },
  "elements": [true, {"id": "b"}]
}`;
const placeOf = (path: string) => placeAt(TEXT, jsonPlaces(TEXT).offsets.get(path)!);

describe('the places in a JSON text', () => {
  it('are found by path', () => {
    expect(placeOf('topic')).toEqual({ line: 2, column: 3 });
    expect(placeOf('pose3D.position.y')).toEqual({ line: 4, column: 27 });
    expect(placeOf('elements[1].id')).toEqual({ line: 6, column: 23 });
    expect(jsonPlaces(TEXT).problem).toBeUndefined();
  });

  it.each([
    ['{"a": }', 7, 'Expected a value, found "}".'],
    ['{"a": 1', 8, 'Expected a comma or }, found the end.'],
    ['{a: 1}', 2, 'Expected a name in double quotes, found "a".'],
    ['[1 2]', 4, 'Expected a comma or ], found "2".'],
    ['{"a": "b}', 7, 'Expected the end of this text, a ", found "\\"".'],
    ['1 2', 3, 'Expected nothing more, found "2".'],
    ['', 1, 'Expected a value, found the end.'],
  ])('%s breaks at column %i', (text, column, sentence) => {
    expect(jsonPlaces(text).problem).toEqual({ line: 1, column, sentence });
  });

  it('agrees with JSON.parse on what is JSON', () => {
    for (const text of ['01', '1.', '-0.5e+3', '"\\u00e9"', '"\\x"', '[,]', '{"a":1,}', 'nul']) {
      let isJson = true;
      try {
        JSON.parse(text);
      } catch {
        isJson = false;
      }
      expect(jsonPlaces(text).problem === undefined, text).toBe(isJson);
    }
  });
});
