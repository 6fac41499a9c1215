import { describe, expect, it } from 'vitest';
import { aRun } from '../testing/a-study.ts';
import { currentNumber, finishedCount, nextNumber, runningNumber, runStage } from './run-stage.ts';

const [PENDING, RUNNING, DONE, SKIPPED, INTERRUPTED] = [0, 1, 2, 3, 4];
const CONSENT = { consent: { version: 1, timeMs: 1 } };

describe('the stage of a run', () => {
  it.each([
    ['consent', aRun([PENDING]), true],
    ['ready', aRun([PENDING]), false],
    ['ready', aRun([DONE, PENDING], CONSENT), true],
    ['running', aRun([DONE, RUNNING, PENDING], CONSENT), true],
    ['done', aRun([DONE, SKIPPED], CONSENT), true],
    ['incomplete', aRun([DONE, INTERRUPTED], CONSENT), true],
    ['ready', aRun([INTERRUPTED, PENDING], CONSENT), true],
    ['interrupted', aRun([DONE, INTERRUPTED], { state: 2 }), false],
    ['ended', aRun([DONE, PENDING], { state: 3 }), true],
  ] as const)('is %s', (stage, run, needsConsent) => {
    expect(runStage(run, needsConsent)).toBe(stage);
  });
});

it('the block that runs comes before the next one', () => {
  const run = aRun([DONE, PENDING, RUNNING, SKIPPED]);
  expect([runningNumber(run), nextNumber(run), currentNumber(run)]).toEqual([3, 2, 3]);
  expect(finishedCount(run)).toBe(2);
  const done = aRun([DONE, INTERRUPTED]);
  expect([currentNumber(done), finishedCount(done)]).toEqual([0, 1]);
});
