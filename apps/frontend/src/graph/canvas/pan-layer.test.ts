import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { PanLayer } from './pan-layer.ts';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

function setUp(canAnimate: boolean) {
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
  const pan = (x: number): void => {
    element.style.transform = `translate(${x}px)`;
    layer.hold();
  };
  return { element, layer, places, animation, pan };
}

it('is a layer at each place of a pan, until the pan has rested', () => {
  const { element, places, animation, pan } = setUp(true);
  pan(1);
  vi.advanceTimersByTime(150);
  pan(2);
  vi.advanceTimersByTime(150);
  expect(places).toEqual(['translate(1px)', 'translate(2px)']);
  expect(animation.pause).toHaveBeenCalledOnce();
  expect(element.style.willChange).toBe('transform');
  vi.advanceTimersByTime(100);
  expect(animation.cancel).toHaveBeenCalledOnce();
  expect(element.style.willChange).toBe('');
});

it('goes where a zoom puts it, and is made no layer by that', () => {
  const { element, layer, places, pan } = setUp(true);
  layer.follow();
  expect(element.style.willChange).toBe('');
  pan(1);
  element.style.transform = 'scale(2)';
  layer.follow();
  expect(places).toEqual(['translate(1px)', 'scale(2)']);
});

it('is moved by its style alone where nothing can be animated', () => {
  const { element, pan } = setUp(false);
  pan(1);
  expect(element.style.transform).toBe('translate(1px)');
  vi.advanceTimersByTime(300);
  expect(element.style.willChange).toBe('');
});
