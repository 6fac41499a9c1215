// @vitest-environment happy-dom
import { expect, it, vi } from 'vitest';
import { shallowRef } from 'vue';
import { Pinch, pinched } from './pinch.ts';

const VIEW = { x: 30, y: -10, k: 0.8 };

it('keeps the place between the fingers between them', () => {
  const from = { x: 100, y: 200 };
  const to = { x: 140, y: 170 };
  const next = pinched(VIEW, from, to, 1.5);
  const onCanvas = (at: { x: number; y: number }, { x, y, k }: typeof VIEW) => [
    (at.x - x) / k,
    (at.y - y) / k,
  ];
  expect(next.k).toBeCloseTo(1.2);
  const [x, y] = onCanvas(from, VIEW);
  const [nextX, nextY] = onCanvas(to, next);
  expect(nextX).toBeCloseTo(x!);
  expect(nextY).toBeCloseTo(y!);
});

it('zooms no further than the canvas does', () => {
  expect(pinched(VIEW, { x: 0, y: 0 }, { x: 0, y: 0 }, 100).k).toBe(2.5);
  expect(pinched(VIEW, { x: 0, y: 0 }, { x: 0, y: 0 }, 0.001).k).toBe(0.1);
});

function setUp() {
  const look = vi.fn(() => Promise.resolve());
  const tapped = vi.fn();
  const container = document.createElement('div');
  return { look, tapped, pinch: new Pinch({ container, look, view: shallowRef(VIEW) }, tapped) };
}

it('is a tap when two fingers are only put down and lifted', () => {
  const { look, tapped, pinch } = setUp();
  const fingers = [
    { x: 0, y: 0 },
    { x: 100, y: 0 },
  ];
  pinch.begin(fingers, 1000);
  pinch.move(fingers);
  pinch.end(1100);
  expect(tapped).toHaveBeenCalledOnce();
  expect(look).not.toHaveBeenCalled();
});

it('is no tap when they moved or stayed', () => {
  const { look, tapped, pinch } = setUp();
  pinch.begin(
    [
      { x: 0, y: 0 },
      { x: 100, y: 0 },
    ],
    1000,
  );
  pinch.move([
    { x: 0, y: 0 },
    { x: 200, y: 0 },
  ]);
  pinch.end(1100);
  expect(look).toHaveBeenCalledWith(expect.objectContaining({ k: 1.6 }));
  pinch.begin(
    [
      { x: 0, y: 0 },
      { x: 100, y: 0 },
    ],
    1000,
  );
  pinch.end(2000);
  expect(tapped).not.toHaveBeenCalled();
});
