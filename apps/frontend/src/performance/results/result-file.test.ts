import { describe, expect, it } from 'vitest';
import { resultsFromJson, resultsToCsv, resultsToJson } from './result-file.ts';
import { aResult } from './testing/a-result.ts';

const NO_RESULTS =
  'The file contains no performance results. Choose a file that this page exported.';

describe('results as JSON', () => {
  it('come back as they were', () => {
    const results = [aResult(), aResult({ id: 'two', ended: 'stopped' })];
    expect(resultsFromJson(resultsToJson(results))).toEqual({ kind: 'read', value: results });
  });

  it.each([
    ['nothing JSON', '{', 'The file is not JSON. It may be cut off or damaged. Export it again.'],
    ['another file', '{"a":1}', NO_RESULTS],
    ['null', 'null', NO_RESULTS],
    [
      'a later version',
      '{"format":"ubi-interact-performance","formatVersion":2,"results":[]}',
      'The file has version 2; this page reads version 1. Create it with the same version of Ubi-Interact.',
    ],
    [
      'no results',
      '{"format":"ubi-interact-performance","formatVersion":1,"results":[]}',
      'The file cannot be read: results should be a list of 1 or more elements.',
    ],
    [
      'a broken result',
      resultsToJson([aResult({ startedMs: 'yesterday' as never })]),
      'The file cannot be read: results[0].startedMs should be a number.',
    ],
    [
      'an unknown test',
      resultsToJson([aResult({ kind: 'juggling' as never })]),
      'The file cannot be read: results[0].kind should be "round-trip" or "load" or "session-speed" or "screen".',
    ],
    [
      'a broken figure',
      resultsToJson([aResult({ findings: { ...aResult().findings, figures: [{} as never] } })]),
      'The file cannot be read: results[0].findings.figures[0].key is missing.',
    ],
  ])('say what is wrong with %s', (_what, text, sentence) => {
    expect(resultsFromJson(text)).toEqual({ kind: 'broken', message: sentence });
  });

  it('leave out what is not known', () => {
    const strange = { ...aResult(), password: 'x' };
    expect(resultsFromJson(resultsToJson([strange]))).toEqual({ kind: 'read', value: [aResult()] });
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
