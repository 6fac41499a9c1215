import { describe, expect, it } from 'vitest';
import { defaultFromText, defaultProblem, textOfDefault } from './io-default.ts';

const io = (format: string, defaultJson?: string, isList = false) => ({
  name: 'a',
  format,
  isList,
  ...(defaultJson !== undefined && { defaultJson }),
});

describe('the default of an input', () => {
  it.each([
    ['double', '1.0', '{"double":1.0}'],
    ['bool', 'true', '{"bool":true}'],
    ['string', 'say "hi"', '{"string":"say \\"hi\\""}'],
    ['vector2', '{"x":1,"y":0}', '{"vector2":{"x":1,"y":0}}'],
  ])('of %s is kept as it is typed: %s', (format, text, json) => {
    expect(defaultFromText(text, format)).toBe(json);
    expect(textOfDefault(io(format, json))).toBe(text);
    expect(defaultProblem(io(format, json))).toBeUndefined();
  });

  it('is none when the field is empty', () => {
    expect(defaultFromText(' ', 'double')).toBeUndefined();
    expect(textOfDefault(io('double'))).toBe('');
    expect(defaultProblem(io('double'))).toBeUndefined();
  });

  it('is kept while it is wrong, and says what to enter', () => {
    const wrong = (format: string, text: string) =>
      io(format, defaultFromText(text, format), format === 'list');
    expect(textOfDefault(wrong('double', '1,'))).toBe('1,');
    expect(defaultProblem(wrong('double', '1,'))).toBe('Enter a number, such as 1.');
    expect(defaultProblem(wrong('double', '"a"'))).toBe('Enter a number, such as 1.');
    expect(defaultProblem(wrong('bool', 'yes'))).toBe('Enter true or false.');
    expect(defaultProblem(wrong('vector2', '1'))).toBe(
      'Enter a vector2 as JSON, such as {"x":0,"y":0}.',
    );
    expect(defaultProblem(io('double', '{"double":1}', true))).toBe(
      'Only an input for one record has a default. Remove the default.',
    );
  });
});
