import { describe, expect, it } from 'vitest';
import { effectOfKey } from './plot-keys.ts';
import { MAX_SPAN_MS, MIN_SPAN_MS, panBy, reveal, zoomBy, zoomTo } from './plot-view.ts';

const bounds = { newestMs: 100_000, oldestMs: 40_000 };
const following = { spanMs: 10_000, endMs: undefined };

describe('a view of a plot', () => {
  it('zooms into a stretch, drawn from either side', () => {
    expect(zoomTo(90_000, 92_000, bounds)).toEqual({ spanMs: 2000, endMs: 92_000 });
    expect(zoomTo(92_000, 90_000, bounds)).toEqual({ spanMs: 2000, endMs: 92_000 });
    expect(zoomTo(90_000, 90_001, bounds).spanMs).toBe(MIN_SPAN_MS);
  });

  it('zooms about a moment that stays where it is', () => {
    const view = zoomBy({ spanMs: 10_000, endMs: 90_000 }, 0.5, 82_500, bounds);
    expect(view).toEqual({ spanMs: 5000, endMs: 86_250 });
    expect((view.endMs! - 82_500) / view.spanMs).toBe(0.75);
  });

  it('goes on following when it is zoomed, and knows its ends', () => {
    expect(zoomBy(following, 2, 0, bounds)).toEqual({ spanMs: 20_000, endMs: undefined });
    expect(zoomBy(following, 1e9, 0, bounds).spanMs).toBe(MAX_SPAN_MS);
  });

  it('moves back and forth, and follows again at the newest', () => {
    const back = panBy(following, -5000, bounds);
    expect(back).toEqual({ spanMs: 10_000, endMs: 95_000 });
    expect(panBy(back, -1e9, bounds).endMs).toBe(50_000);
    expect(panBy(back, 6000, bounds)).toEqual(following);
  });

  it('brings a moment into view', () => {
    expect(reveal(following, 95_000, bounds)).toBe(following);
    expect(reveal(following, 60_000, bounds)).toEqual({ spanMs: 10_000, endMs: 65_000 });
  });
});

describe('the keys of a plot', () => {
  const target = { view: following, bounds, width: 1000, readingX: 500 };
  const press = (key: string, shiftKey = false) => effectOfKey({ key, shiftKey }, target);

  it('read, move, zoom and follow', () => {
    expect(press('ArrowLeft')).toEqual({ readingX: 490 });
    expect(press('ArrowLeft', true)).toEqual({ view: { spanMs: 10_000, endMs: 99_000 } });
    expect(press('+')).toEqual({ view: { spanMs: 10_000 / 1.4, endMs: undefined } });
    expect(press('PageUp')).toEqual({ view: { spanMs: 10_000, endMs: 90_000 } });
    expect(press('Home')).toEqual({ view: following });
    expect(press('Escape')).toEqual({ readingX: undefined });
  });

  it('place cursors and find records', () => {
    expect(press('a')).toEqual({ cursor: 0, x: 500 });
    expect(press('B')).toEqual({ cursor: 1, x: 500 });
    expect(press('Enter')).toEqual({ pickX: 500 });
    expect(press('q')).toBeUndefined();
  });
});
