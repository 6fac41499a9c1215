import { describe, expect, it } from 'vitest';
import { jsonLines } from './json-lines.ts';

const TEXT = `{
  "name": "Two hands",
  "ioMappings": [
    {
      "inputMappings": [
        { "inputName": "a", "topic": "/a" },
        { "inputName": "b",
          "topic": "/b" }
      ]
    }
  ],
  "n": [-1.5e3, true, null, []],
  "o": {}
}
`;

describe('jsonLines', () => {
  it('finds the line of a path', () => {
    const lines = jsonLines(TEXT);
    if (lines.kind !== 'read') throw new Error(lines.message);
    expect(lines.lineOf('name')).toBe(2);
    expect(lines.lineOf('ioMappings[0].inputMappings[1].topic')).toBe(8);
    expect(lines.lineOf('ioMappings[0].inputMappings[0]')).toBe(6);
  });

  it('shows what is missing at what is around it', () => {
    const lines = jsonLines(TEXT);
    if (lines.kind !== 'read') throw new Error(lines.message);
    expect(lines.lineOf('ioMappings[0].inputMappings[1].topicMux.id')).toBe(7);
    expect(lines.lineOf('ioMappings[3].outputMappings')).toBe(3);
    expect(lines.lineOf('processingModules')).toBe(1);
    expect(lines.lineOf('')).toBeUndefined();
  });

  it.each([
    ['', 1, 'The text is empty.'],
    ['{\n  "a": 1\n  "b": 2\n}', 3, 'Expected a comma or }, found """.'],
    ['{\n  a: 1 }', 2, 'Expected a name in quotes, found "a".'],
    ['{ "a": 1, }', 1, 'Expected a name in quotes, found "}".'],
    ['{ "a" 1 }', 1, 'Expected a colon after "a", found "1".'],
    ['[1,\n2', 2, 'Expected a comma or ], found the end of the text.'],
    ['{ "a": undefined }', 1, 'Expected a value, found "undefined".'],
    ['{} {}', 1, 'Expected the end of the text, found "{".'],
    ['["a\nb"]', 1, 'The string does not end on its line, or contains an invalid escape.'],
  ])('says where and why %j is no JSON', (text, line, message) => {
    expect(jsonLines(text)).toMatchObject({ kind: 'broken', line, message });
    expect(() => JSON.parse(text) as unknown).toThrow();
  });
});
