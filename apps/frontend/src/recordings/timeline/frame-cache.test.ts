import { describe, expect, it } from 'vitest';
import { FrameCache } from './frame-cache.ts';

function setUp() {
  const asked: number[] = [];
  const dropped: number[] = [];
  const cache = new FrameCache<{ width: number; height: number }>(
    (_topic, timeMs) => asked.push(timeMs),
    ({ width }) => dropped.push(width),
  );
  const picture = (width: number) => ({ width, height: 1 });
  return { cache, asked, dropped, picture };
}

describe('pictures of a film strip', () => {
  it('are asked for once, few at a time, the newest wish first', () => {
    const { cache, asked, picture } = setUp();
    for (const timeMs of [1, 2, 3, 4, 5, 4]) cache.get('/a', timeMs);
    expect(asked).toEqual([1, 2, 3]);
    cache.take('/a', 1, picture(1));
    cache.take('/a', 2, picture(2));
    expect(asked).toEqual([1, 2, 3, 4, 5]);
    expect(cache.get('/a', 1)).toEqual(picture(1));
  });

  it('that cannot be decoded are not asked for again', () => {
    const { cache, asked } = setUp();
    cache.get('/a', 1);
    cache.take('/a', 1, undefined);
    cache.get('/a', 1);
    expect(asked).toEqual([1]);
  });

  it('of places that left the view are not read', () => {
    const { cache, asked, picture } = setUp();
    for (const timeMs of [1, 2, 3, 4]) cache.get('/a', timeMs);
    cache.forgetWishes();
    cache.take('/a', 1, picture(1));
    expect(asked).toEqual([1, 2, 3]);
  });

  it('are bounded, and given back', () => {
    const { cache, dropped, picture } = setUp();
    for (let timeMs = 0; timeMs < 300; timeMs++) cache.take('/a', timeMs, picture(timeMs));
    expect(dropped).toHaveLength(60);
    expect(dropped[0]).toBe(0);
    cache.close();
    expect(dropped).toHaveLength(300);
  });
});
