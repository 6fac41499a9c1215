import { describe, expect, it } from 'vitest';
import { moduleOf } from '../../draft/module-draft.ts';
import { TEMPLATES } from '../../draft/templates.ts';
import { applyFix, codeFixes } from './code-fixes.ts';
import { typeWords } from './type-words.ts';

const io = (name: string, format = 'double') => ({ name, format, isList: false });
const draftWith = (code: string) => ({
  ...TEMPLATES[0]!.draft,
  inputs: [io('value'), io('gain')],
  outputs: [io('result')],
  code,
});
const CODE = `onProcessing = (deltaTimeMs, inputs, state) => {
  const factor = inputs.gian.vector2;
  return { outputs: { reslt: { elements: [] } } };
};
`;
const draft = draftWith(CODE);
const mark = (message: string, line: number, column: number) => ({
  message: typeWords(message, draft),
  line,
  column,
});
const INPUT = mark("Property 'gian' does not exist on type 'Inputs'. Did you mean 'gain'?", 2, 25);
const OUTPUT = mark(
  "Object literal may only specify known properties, but 'reslt' does not exist in type 'Outputs'. Did you mean to write 'result'?",
  3,
  23,
);
const titles = (found: typeof INPUT, of = draft): readonly string[] =>
  codeFixes(found, of).map(({ title }) => title);

describe('quick fixes', () => {
  it('offer what the message names', () => {
    expect(titles(INPUT)).toEqual(['Change to gain', 'Add an input gian']);
    expect(titles(OUTPUT)).toEqual(['Change to result', 'Add an output reslt']);
    expect(titles(mark("Property 'speed' does not exist on type 'Inputs'.", 2, 25))).toEqual([
      'Add an input speed',
    ]);
    const name = mark("Cannot find name 'factr'. Did you mean 'factor'?", 2, 9);
    expect(titles(name, draftWith(CODE.replace('factor', 'factr ')))).toEqual(['Change to factor']);
  });

  it('offer nothing else', () => {
    expect(titles(mark("Property 'missing' does not exist on type 'number'.", 2, 25))).toEqual([]);
    expect(titles(mark("';' expected.", 2, 25))).toEqual([]);
  });

  it('rename only the word that the message names', () => {
    const [change] = codeFixes(INPUT, draft);
    expect(applyFix(draft, INPUT, change!)).toEqual({ code: CODE.replace('gian', 'gain') });
    expect(titles({ ...INPUT, column: 3 })).toEqual(['Add an input gian']);
  });

  it('add an input or output to the form, in the format that the code uses', () => {
    const [, input] = codeFixes(INPUT, draft);
    expect(applyFix(draft, INPUT, input!)).toEqual({
      inputs: [...draft.inputs, io('gian', 'vector2')],
    });
    const [, output] = codeFixes(OUTPUT, draft);
    expect(applyFix(draft, OUTPUT, output!)).toEqual({
      outputs: [...draft.outputs, { ...io('reslt'), isList: true }],
    });
  });

  it('return before an input is read that may have no value', () => {
    const found = mark("'inputs.gain' is possibly 'undefined'.", 2, 18);
    const [guard] = codeFixes(found, draft);
    expect(guard?.title).toBe('Return while inputs.gain has no value');
    const { code } = applyFix(draft, found, guard!);
    expect(code).toBe(CODE.replace('{\n', '{\n  if (!inputs.gain) return;\n'));
    expect(moduleOf(draftWith(code!)).onProcessingStringified).toContain('if (!inputs.gain)');
  });
});
