import { describe, expect, it } from 'vitest';
import { detailAt, overlaps, seenArea } from './seen-area.ts';

const VIEWPORT = { width: 800, height: 600 };

describe('what is drawn of the canvas', () => {
  it('is more than what is seen', () => {
    const area = seenArea({ x: 0, y: 0, k: 1 }, VIEWPORT, undefined);
    expect(overlaps(area, { x: -100, y: -100, width: 50, height: 50 })).toBe(true);
    expect(overlaps(area, { x: 2000, y: 0, width: 50, height: 50 })).toBe(false);
  });

  it('stays the same while a pan shows nothing else', () => {
    const area = seenArea({ x: 0, y: 0, k: 1 }, VIEWPORT, undefined);
    expect(seenArea({ x: 100, y: -200, k: 1 }, VIEWPORT, area)).toBe(area);
    expect(seenArea({ x: 300, y: 0, k: 1 }, VIEWPORT, area)).not.toBe(area);
  });

  it('shrinks when much less is seen', () => {
    const area = seenArea({ x: 0, y: 0, k: 0.25 }, VIEWPORT, undefined);
    expect(seenArea({ x: 0, y: 0, k: 1 }, VIEWPORT, area).width).toBeLessThan(area.width);
  });

  it('says less from afar', () => {
    expect([0.2, 0.5, 1].map(detailAt)).toEqual(['far', 'plain', 'near']);
  });
});
