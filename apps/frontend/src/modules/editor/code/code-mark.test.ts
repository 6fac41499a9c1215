import { describe, expect, it } from 'vitest';
import { firstCauses, type CodeMark, type TypeMark } from './code-mark.ts';

const mark = (line: number, message: string): CodeMark => ({
  line,
  column: 1,
  severity: 'error',
  message,
});
const type = (line: number, message: string, isSyntax = false): TypeMark => ({
  ...mark(line, message),
  isSyntax,
});
const texts = (marks: readonly CodeMark[], types: readonly TypeMark[]): readonly string[] =>
  firstCauses(marks, types).map(({ message }) => message);

describe('marks in the code', () => {
  const engine = mark(2, "SyntaxError: expecting ';'");

  it('tell a mistake once, whoever found it', () => {
    expect(texts([engine, engine], [])).toEqual(["SyntaxError: expecting ';'"]);
    expect(texts([engine, engine], [type(2, "';' expected.", true)])).toEqual(["';' expected."]);
  });

  it('leave out what follows from a text that is no JavaScript', () => {
    expect(texts([engine], [type(2, "Cannot find name 'foo'.")])).toHaveLength(1);
    expect(texts([], [type(2, 'a type'), type(3, "';' expected.", true)])).toEqual([
      "';' expected.",
    ]);
  });

  it('leave out what a run says of a line whose mistake is known', () => {
    const run = { ...mark(2, 'TypeError: cannot read property of undefined'), isOfRun: true };
    expect(texts([run], [type(2, 'Input "valu" is not declared.')])).toEqual([
      'Input "valu" is not declared.',
    ]);
    expect(texts([run], [type(3, 'another')])).toHaveLength(2);
  });

  it('tell what JSON.parse throws beside what types say', () => {
    const run = { ...mark(4, 'SyntaxError: unexpected token: oops'), isOfRun: true };
    const types = [type(2, 'Input "valu" is not declared.'), type(3, "';' expected.", true)];
    expect(texts([run], types.slice(0, 1))).toHaveLength(2);
    expect(texts([run], types)).toContain(run.message);
  });

  it('come errors first, then by place', () => {
    const late = { ...mark(1, 'a hint'), severity: 'warning' as const };
    expect(texts([late, mark(3, 'third')], [type(2, 'second')])).toEqual([
      'second',
      'third',
      'a hint',
    ]);
  });
});
