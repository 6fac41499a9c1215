import type { Image2D } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { HeldPictures } from './held-pictures.ts';
import { opacityAt, ResultLag } from './result-lag.ts';

/** Shows `count` results of age `lagMs` at intervals of `everyMs`. */
function show(lag: ResultLag, lagMs: number, everyMs: number, count: number, fromMs = 0): number {
  for (let at = 0; at < count * everyMs; at += 10) {
    lag.note(fromMs + Math.floor(at / everyMs) * everyMs, fromMs + at + lagMs);
  }
  return fromMs + count * everyMs;
}

describe('the lag of results', () => {
  it('is that of the moment before the next result comes', () => {
    const lag = new ResultLag();
    show(lag, 90, 500, 3);
    expect(lag.medianMs).toBe(580);
    expect(lag.isBehind).toBe(true);
  });

  it('is none at normal rates, and one late result changes nothing', () => {
    const lag = new ResultLag();
    const nowMs = show(lag, 60, 100, 10);
    expect(lag.isBehind).toBe(false);
    lag.note(nowMs, nowMs + 900);
    expect(lag.isBehind).toBe(false);
  });

  it('ends only well below the limit, so that the stage does not alternate', () => {
    const lag = new ResultLag();
    let nowMs = show(lag, 100, 250, 5);
    expect(lag.isBehind).toBe(true);
    nowMs = show(lag, 100, 150, 5, nowMs);
    expect(lag.isBehind).toBe(true);
    show(lag, 50, 100, 5, nowMs);
    expect(lag.isBehind).toBe(false);
  });

  it('is unknown without a result', () => {
    const lag = new ResultLag();
    show(lag, 900, 500, 3);
    lag.note(undefined, 5000);
    expect([lag.isBehind, lag.medianMs]).toEqual([false, 0]);
  });
});

it('results fade with their age, and stay visible', () => {
  expect([0, 300, 650, 1000, 9000].map(opacityAt)).toEqual([1, 1, 0.5, 0.25, 0.25]);
});

it('holds the last pictures within its limits', () => {
  const held = new HeldPictures();
  const picture = (bytes: number) => ({ data: new Uint8Array(bytes) }) as Image2D;
  held.add(1000.4, picture(10_000_000));
  held.add(1100, picture(10_000_000));
  expect(held.at(1000.1)).toBeDefined();
  held.add(1200, picture(10_000_000));
  expect([1000, 1100, 1200].map((takenMs) => held.at(takenMs) !== undefined)).toEqual([
    false,
    true,
    true,
  ]);
  held.clear();
  expect(held.at(1200)).toBeUndefined();
});
