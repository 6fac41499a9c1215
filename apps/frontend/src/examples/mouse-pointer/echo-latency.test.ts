import { describe, expect, it } from 'vitest';
import { EchoLatencyWindow } from './echo-latency.ts';

const at = (timestampMs: number, x = 0.5, y = 0.5) => ({ timestampMs, x, y });

describe('EchoLatencyWindow', () => {
  it('measures nothing before the first echo', () => {
    expect(new EchoLatencyWindow().summary()).toBeUndefined();
  });

  it('gives the time between sending and return', () => {
    const window = new EchoLatencyWindow();
    window.sent(at(1), 100);
    expect(window.returned(at(1), 103.5)).toBe(3.5);
    expect(window.summary()).toEqual({ lastMs: 3.5, p50Ms: 3.5, p95Ms: 3.5, count: 1 });
  });

  it('tells records of one millisecond apart by their position', () => {
    const window = new EchoLatencyWindow();
    window.sent(at(1, 0.1), 100);
    window.sent(at(1, 0.2), 101);
    expect(window.returned(at(1, 0.1), 110)).toBe(10);
    expect(window.returned(at(1, 0.2), 110)).toBe(9);
  });

  it('skips records that were dropped on the way [TD-15]', () => {
    const window = new EchoLatencyWindow();
    window.sent(at(1), 100);
    window.sent(at(2), 110);
    expect(window.returned(at(2), 112)).toBe(2);
    expect(window.returned(at(1), 113)).toBeUndefined();
  });

  it('ignores a record it never sent, such as the retained one of an earlier visit', () => {
    expect(new EchoLatencyWindow().returned(at(9), 1)).toBeUndefined();
  });

  it('gives percentiles by nearest rank', () => {
    const window = new EchoLatencyWindow();
    for (let i = 1; i <= 100; i++) {
      window.sent(at(i), 0);
      window.returned(at(i), i);
    }
    expect(window.summary()).toEqual({ lastMs: 100, p50Ms: 50, p95Ms: 95, count: 100 });
    expect(window.recent(3)).toEqual([98, 99, 100]);
  });

  it('stays bounded when nothing returns', () => {
    const window = new EchoLatencyWindow();
    for (let i = 0; i < 5000; i++) window.sent(at(i), i);
    expect(window.returned(at(0), 1)).toBeUndefined();
    expect(window.returned(at(4999), 5000)).toBe(1);
  });

  it('forgets on clear', () => {
    const window = new EchoLatencyWindow();
    window.sent(at(1), 0);
    window.clear();
    expect(window.returned(at(1), 5)).toBeUndefined();
  });
});
