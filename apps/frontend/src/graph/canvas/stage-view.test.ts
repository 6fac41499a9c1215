import { describe, expect, it } from 'vitest';
import { mapCorner } from './map-corner.ts';
import {
  clearViewOf,
  insideNode,
  limitZoom,
  MAX_ZOOM,
  MIN_ZOOM,
  viewOf,
  type Box,
  type View,
} from './stage-view.ts';

describe('viewOf', () => {
  const viewport = { width: 1000, height: 700 };

  it('puts a small box in the middle of what nothing covers, at its own size', () => {
    const { x, y, k } = viewOf({ x: 100, y: 50, width: 200, height: 100 }, viewport);
    expect(k).toBe(1);
    expect({ x: 200 * k + x, y: 100 * k + y }).toEqual({ x: 500, y: 358 });
  });

  it('shows all of a large box, above what covers the bottom', () => {
    const box = { x: -500, y: 0, width: 4000, height: 3000 };
    const { x, y, k } = viewOf(box, viewport, 60);
    expect(box.x * k + x).toBeGreaterThan(0);
    expect((box.x + box.width) * k + x).toBeLessThan(viewport.width);
    expect(box.y * k + y).toBeGreaterThan(0);
    expect((box.y + box.height) * k + y).toBeLessThan(viewport.height - 60);
  });

  it('fills a small pane to its own margins', () => {
    const margins = { top: 16, side: 20, bottom: 16 };
    const box = { x: 0, y: 0, width: 200, height: 120 };
    const { y, k } = viewOf(box, { width: 600, height: 152 }, 0, margins);
    expect({ y, k }).toEqual({ y: 16, k: 1 });
  });

  it('keeps the zoom in its limits', () => {
    expect(viewOf({ x: 0, y: 0, width: 1e6, height: 1e6 }, viewport).k).toBe(MIN_ZOOM);
    expect(limitZoom(100)).toBe(MAX_ZOOM);
    expect(limitZoom(0)).toBe(MIN_ZOOM);
  });
});

describe('clearViewOf', () => {
  const viewport = { width: 1000, height: 700 };
  const cover = { bottom: 60, corner: mapCorner };
  const boxAt = (x: number, y: number): Box => ({ x, y, width: 200, height: 100 });
  const right = (view: View, box: Box) => (box.x + box.width) * view.k + view.x;
  const bottom = (view: View, box: Box) => (box.y + box.height) * view.k + view.y;

  it('leaves the view as it is while no node is behind the minimap', () => {
    const boxes = [boxAt(0, 0), boxAt(900, 0), boxAt(0, 700)];
    const all = { x: 0, y: 0, width: 1100, height: 800 };
    expect(clearViewOf(boxes, viewport, cover)).toEqual(viewOf(all, viewport, cover.bottom));
  });

  it.each([
    ['beside', [boxAt(0, 0), boxAt(700, 900)]],
    ['above', [boxAt(0, 0), boxAt(1600, 300)]],
  ])('shows nodes %s the minimap instead of behind it', (where, boxes) => {
    const { width, height } = mapCorner(viewport)!;
    const view = clearViewOf(boxes, viewport, cover);
    const [, last] = boxes;
    if (where === 'beside') expect(right(view, last!)).toBeLessThan(viewport.width - width);
    else expect(bottom(view, last!)).toBeLessThanOrEqual(viewport.height - height);
  });

  it('keeps nothing free on small canvases, which have no minimap', () => {
    expect(mapCorner({ width: 390, height: 700 })).toBeUndefined();
  });
});

describe('insideNode', () => {
  it('has no socket below the frame of its node', () => {
    const size = { width: 184, height: 117 };
    expect(insideNode({ x: 183, y: 142 }, size)).toEqual({ x: 183, y: 105 });
    expect(insideNode({ x: 183, y: 60 }, size)).toEqual({ x: 183, y: 60 });
    // Before measurement.
    expect(insideNode({ x: 183, y: 60 }, { width: 0, height: 0 })).toEqual({ x: 183, y: 60 });
  });
});
