// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { PanLayer } from './pan-layer.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

function setUp(canAnimate = true) {
  const element = document.createElement('div');
  const places: unknown[] = [];
  const note = (keyframes: { transform: string[] }): number => places.push(keyframes.transform[0]);
  const animation = { pause: vi.fn(), cancel: vi.fn(), effect: { setKeyframes: note } };
  const animate = (keyframes: { transform: string[] }) => {
    note(keyframes);
    return animation;
  };
  Object.assign(element, { animate: canAnimate ? animate : undefined });
  const layer = new PanLayer(element);
  const pan = (x: number, y = 0): void => layer.hold({ x, y, k: 1 });
  return { element, layer, places, animation, pan };
}

it('is a layer at each place of a pan, until the pan has rested', () => {
  const { places, animation, pan } = setUp();
  pan(1);
  vi.advanceTimersByTime(150);
  pan(2);
  vi.advanceTimersByTime(150);
  expect(places).toEqual(['translate(1px, 0px) scale(1)', 'translate(2px, 0px) scale(1)']);
  expect(animation.pause).toHaveBeenCalledOnce();
  expect(animation.cancel).not.toHaveBeenCalled();
  vi.advanceTimersByTime(100);
  expect(animation.cancel).toHaveBeenCalledOnce();
});

it('goes by whole pixels of the screen from where it began', () => {
  vi.stubGlobal('devicePixelRatio', 2);
  const { places, pan } = setUp();
  pan(0.3);
  pan(5.1, 7.6);
  expect(places.at(-1)).toBe('translate(5.3px, 7.5px) scale(1)');
});

it('goes exactly where a zoom puts it, and is made no layer by that', () => {
  const { layer, places, pan } = setUp();
  layer.follow({ x: 0, y: 0, k: 1 });
  expect(places).toEqual([]);
  pan(1);
  layer.follow({ x: 0.6, y: 0, k: 2 });
  expect(places).toEqual(['translate(1px, 0px) scale(1)', 'translate(0.6px, 0px) scale(2)']);
});

it('is left to its style where nothing can be animated', () => {
  const { places, pan } = setUp(false);
  pan(1);
  pan(2);
  vi.advanceTimersByTime(300);
  expect(places).toEqual([]);
});
