import { describe, expect, it } from 'vitest';
import type { Callee } from './call-series.ts';
import { measureCalls } from './measure-calls.ts';

const OPTIONS = { warmUpMs: 1, measureMs: 5 };

function callee(answer: (sequence: number) => Promise<number>): Callee<number, number> {
  return {
    sequence: 0,
    prepare: (sequence) => sequence,
    call: answer,
    isRight: (got, sequence) => got === sequence,
  };
}

describe('measureCalls', () => {
  it('counts calls and continues with their numbers', async () => {
    const echo = callee((sequence) => Promise.resolve(sequence));
    const first = await measureCalls(echo, OPTIONS);
    const reached = echo.sequence;
    await measureCalls(echo, OPTIONS);
    expect(first.faults).toEqual([]);
    expect(first.deliveries).toBeGreaterThan(0);
    expect(echo.sequence).toBeGreaterThan(reached);
  });

  it('says so when answers are wrong or calls fail', async () => {
    const wrong = await measureCalls(
      callee((sequence) => Promise.resolve(sequence + 1)),
      OPTIONS,
    );
    expect(wrong.faults[0]).toMatch(/^(\d+) of \1 answers were wrong$/);
    const failing = await measureCalls(
      callee(() => Promise.reject(new Error('no way'))),
      OPTIONS,
    );
    expect(failing.faults).toEqual(['call 1 failed: no way']);
  });
});
