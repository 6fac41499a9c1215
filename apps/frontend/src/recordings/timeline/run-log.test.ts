import { describe, expect, it } from 'vitest';
import { RunLog } from './run-log.ts';

describe('runs of a track', () => {
  it('last while the same text comes, and end with another', () => {
    const log = new RunLog(1, 1000);
    log.add(0, ['rest']);
    log.add(100, ['rest']);
    log.add(200, ['swipe']);
    log.add(300, ['rest']);
    expect(log.runs(350)).toEqual([
      { label: 'rest', fromMs: 0, untilMs: 200, lane: 0 },
      { label: 'swipe', fromMs: 200, untilMs: 300, lane: 0 },
      { label: 'rest', fromMs: 300, untilMs: 350, lane: 0 },
    ]);
  });

  it('give each thing a lane while it is seen', () => {
    const log = new RunLog(3, 1000);
    log.add(0, ['person']);
    log.add(100, ['person', 'cup']);
    log.add(200, ['cup']);
    log.add(300, ['cup', 'dog']);
    const lanes = Object.fromEntries(log.runs(300).map(({ label, lane }) => [label, lane]));
    expect(lanes).toEqual({ person: 0, cup: 1, dog: 0 });
  });

  it('end when no record comes for long', () => {
    const log = new RunLog(1, 500);
    log.add(0, ['on']);
    log.add(100, ['on']);
    log.add(5000, ['on']);
    expect(log.runs(5000)).toEqual([
      { label: 'on', fromMs: 0, untilMs: 100, lane: 0 },
      { label: 'on', fromMs: 5000, untilMs: 5000, lane: 0 },
    ]);
  });
});
