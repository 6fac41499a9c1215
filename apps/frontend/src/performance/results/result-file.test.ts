import { describe, expect, it } from 'vitest';
import { resultsFromJson, resultsToCsv, resultsToJson } from './result-file.ts';
import { aResult } from './testing/a-result.ts';

describe('results as JSON', () => {
  it('come back as they were', () => {
    const results = [aResult(), aResult({ id: 'two', ended: 'stopped' })];
    expect(resultsFromJson(resultsToJson(results))).toEqual(results);
  });

  it.each([
    ['nothing JSON', '{', 'The file should be JSON, as exported by this page.'],
    ['another file', '{"a":1}', 'The file should be a JSON export of this page.'],
    ['null', 'null', 'The file should be a JSON export of this page.'],
    [
      'a later version',
      '{"format":"ubi-interact-performance","formatVersion":2,"results":[]}',
      'The version of the file should be 1.',
    ],
    [
      'no results',
      '{"format":"ubi-interact-performance","formatVersion":1,"results":[]}',
      'results should be a list of 1 to 100 results.',
    ],
    [
      'a broken result',
      resultsToJson([aResult({ startedMs: 'yesterday' as never })]),
      'results[0].startedMs should be a number.',
    ],
    [
      'an unknown test',
      resultsToJson([aResult({ kind: 'juggling' as never })]),
      'results[0].kind should be "round-trip" or "load" or "session-speed" or "screen".',
    ],
    [
      'a broken figure',
      resultsToJson([aResult({ findings: { ...aResult().findings, figures: [{} as never] } })]),
      'results[0].findings.figures[0].key should be a text of up to 2000 characters.',
    ],
  ])('say what is wrong with %s', (_what, text, sentence) => {
    expect(() => resultsFromJson(text)).toThrow(sentence);
  });

  it('leave out what is not known', () => {
    const strange = { ...aResult(), password: 'x' };
    expect(resultsFromJson(resultsToJson([strange]))).toEqual([aResult()]);
  });
});

describe('results as CSV', () => {
  it('have one value a line', () => {
    const [head, ...lines] = resultsToCsv([aResult()]).trimEnd().split('\r\n');
    expect(head).toBe('result,test,started,section,key,label,x,value,unit');
    const first = 'Round trip,round-trip,2026-01-02T03:04:05.000Z';
    expect(lines).toContain(`${first},parameter,rate,Rate,,100,Hz`);
    expect(lines).toContain(`${first},circumstance,browser,Browser,,"Firefox 110, ""nightly""",`);
    expect(lines).toContain(`${first},figure,immediate.p50,p50,,1.5,ms`);
    expect(lines).toContain(`${first},histogram,immediate,Immediate,1,2,count`);
    expect(lines).toContain(`${first},curve,immediate.p50,p50,0,1.5,ms`);
    expect(lines.filter((line) => line.includes(',curve,'))).toHaveLength(1);
  });

  it('are no formulas', () => {
    expect(resultsToCsv([aResult({ name: '=1+1' })])).toContain("'=1+1,round-trip");
  });
});
