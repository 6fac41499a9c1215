import { describe, expect, it } from 'vitest';
import { openingView } from './opening-view.ts';

const ALL = { x: 100, y: 50, width: 900, height: 400 };
const FIRST = { x: 100, y: 50, width: 200, height: 100 };
const PHONE = { width: 390, height: 700 };
const SCREEN = { width: 1024, height: 700 };
const opened = (k: number, viewport: typeof PHONE, all = ALL, boxes = [FIRST]) =>
  openingView({ x: 0, y: 0, k }, boxes, all, viewport);

describe('the view in which a graph opens', () => {
  it.each([
    ['a phone', PHONE, 0.4],
    ['a wide screen', SCREEN, 0.56],
  ])('begins where the graph begins when all of it would be too small on %s', (_what, to, k) => {
    const tall = { ...ALL, width: 2000, height: 2000 };
    const view = opened(k, to, tall);
    expect(view?.k).toBe(0.7);
    expect(100 * 0.7 + view!.x).toBeCloseTo(24);
    expect(50 * 0.7 + view!.y).toBeCloseTo(76);
  });

  it('shows all of what can be read', () => {
    expect(opened(0.45, PHONE)).toBeUndefined();
    expect(opened(0.6, SCREEN)).toBeUndefined();
    expect(openingView({ x: 0, y: 0, k: 0.3 }, [], undefined, PHONE)).toBeUndefined();
  });

  it('has what is narrower than the screen in the middle', () => {
    const view = opened(0.4, SCREEN, { ...ALL, height: 3000 })!;
    expect(view.x + 100 * view.k).toBeCloseTo((1024 - 900 * 0.7) / 2);
  });

  it('shows the first node of a column that begins further down', () => {
    const input = { x: 100, y: 1500, width: 200, height: 100 };
    const later = { x: 500, y: 50, width: 200, height: 100 };
    const view = opened(0.3, SCREEN, { ...ALL, height: 3000 }, [later, input])!;
    expect(1600 * view.k + view.y).toBeLessThan(SCREEN.height);
  });
});
