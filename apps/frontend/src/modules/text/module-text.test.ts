import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { maskSource } from './mask-source.ts';
import { addressInText, composeText, placeInText, sourcesOf, splitText } from './module-text.ts';

const NONE = {
  onCreatedStringified: '',
  onProcessingStringified: '',
  onHaltedStringified: '',
  onDestroyedStringified: '',
};
const module = {
  ...NONE,
  onCreatedStringified: '(state) => {\n  state.count = 0;\n}',
  onProcessingStringified:
    "({ onProcessing(deltaTimeMs, inputs) {\n  const s = '; onHalted = 1';\n  return { outputs: {} };\n} })['onProcessing']",
};

describe('the text of a module', () => {
  it('holds the callbacks as they travel, and gives them back unchanged [PM-2]', () => {
    const text = composeText(module);
    expect(text).toMatch(/^onCreated = \(state\)/);
    expect(splitText(text).problems).toEqual([]);
    expect(sourcesOf(splitText(text))).toEqual(module);
  });

  it('finds the place that a problem of a run names', () => {
    const text = splitText('onCreated = () => undefined\n\nonProcessing = () => {\n  fail();\n}');
    expect(addressInText(text, 'onProcessing:2:3')).toEqual({ line: 4, column: 3 });
    expect(addressInText(text, 'onHalted:2:3')).toBeUndefined();
  });

  it('is not misled by what stands in strings, templates, expressions and comments', () => {
    const tricky =
      '(d) => { // onHalted = 1;\n const r = /[;/]"/; return `;${"}"};\nonHalted = 2`; }';
    const text = `onProcessing = ${tricky}\nonHalted = () => undefined`;
    const split = splitText(text);
    expect(split.problems).toEqual([]);
    expect(sourcesOf(split)).toEqual({
      ...NONE,
      onProcessingStringified: tricky,
      onHaltedStringified: '() => undefined',
    });
  });

  it('says what would be lost, and where', () => {
    const text = '// ours\nconst x = 1;\nonProcessing = () => {};\n// tail\n';
    expect(splitText(text).problems).toMatchObject([
      { line: 2, column: 1, severity: 'error' },
      { line: 4, column: 1, severity: 'warning' },
    ]);
  });

  it('misses onProcessing, and finds what is there twice [PM-1]', () => {
    expect(splitText('').problems[0]?.message).toContain('onProcessing');
    const twice = splitText('onProcessing = () => 1;\nonProcessing = () => 2;');
    expect(twice.problems).toMatchObject([{ line: 2, message: 'onProcessing is defined twice.' }]);
  });

  it('finds the place of a fault [PM-13]', () => {
    const split = splitText(composeText(module));
    expect(placeInText(split, { phase: 'onCreated', line: 1, column: 2 })).toEqual({
      line: 1,
      column: 14,
    });
    expect(placeInText(split, { phase: 'onProcessing', line: 2, column: 3 })).toEqual({
      line: 6,
      column: 3,
    });
    expect(placeInText(split, { phase: '' })).toBeUndefined();
  });

  it('masks any text to the same length and lines', () => {
    const letters = fc.constantFrom(...'ab=;(){}[]\'"`/\\\n$*'.split(''));
    fc.assert(
      fc.property(fc.array(letters, { maxLength: 60 }), (list) => {
        const text = list.join('');
        const mask = maskSource(text);
        expect(mask).toHaveLength(text.length);
        expect(mask.split('\n')).toHaveLength(text.split('\n').length);
      }),
    );
  });
});
