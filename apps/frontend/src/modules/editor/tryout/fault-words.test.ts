import { expect, it } from 'vitest';
import type { CodeMark } from '../code/code-mark.ts';
import { faultWords } from './fault-words.ts';

const known: CodeMark = {
  line: 5,
  column: 21,
  severity: 'error',
  message: 'Output "reslt" is not declared.',
};
const COMPACT = 'The code has an error.';

it('leads to a mistake that is listed, by its sentence or by its line', () => {
  expect(faultWords(known.message, undefined, [known])).toEqual({ text: COMPACT, place: known });
  expect(faultWords('TypeError: not a function', { line: 5, column: 2 }, [known])).toEqual({
    text: COMPACT,
    place: known,
  });
});

it('tells a fault that only the run found', () => {
  const run = { ...known, isOfRun: true };
  const place = { line: 7, column: 1 };
  expect(faultWords('It took too long.', place, [known, run])).toEqual({
    text: 'It took too long.',
    place,
  });
  expect(faultWords(known.message, place, [run])).toEqual({ text: known.message, place });
});
