import type { Point } from '../model/graph.ts';
import type { View } from './stage-view.ts';

/** How long a pan rests before it has ended, milliseconds. */
const REST_MS = 200;

/**
 * Makes what is panned a layer of its own, which browsers move without drawing it again.
 *
 * It is an animation that stands still, at one place after the other: Chromium puts all layers of a page
 * together again whenever the transform of one has changed, unless it is animated. It is no
 * `will-change`, with which Chromium draws what is small as large as at 100 %, only to make it smaller
 * in each frame. And it goes by whole pixels of the screen, or each frame would be drawn again.
 */
export class PanLayer {
  readonly #element: HTMLElement;
  #animation: Animation | undefined;
  /** Where it was when it became a layer, or was zoomed last. */
  #start: Point = { x: 0, y: 0 };
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(element: HTMLElement) {
    this.#element = element;
  }

  /** The element was moved: it is a layer from now on, until it has rested for a while. */
  hold(view: View): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.release(), REST_MS);
    if (this.#animation === undefined) {
      this.#start = view;
      const timing: KeyframeAnimationOptions = { duration: 1, fill: 'both' };
      this.#animation = this.#element.animate?.(keyframes(view), timing);
      this.#animation?.pause();
    } else this.#move(view);
  }

  /** The element was zoomed: while it is a layer, it goes there. */
  follow(view: View): void {
    this.#start = view;
    this.#move(view);
  }

  /** It is drawn together with all else again. */
  release(): void {
    clearTimeout(this.#timer);
    this.#animation?.cancel();
    this.#animation = undefined;
  }

  #move({ x, y, k }: View): void {
    const { x: startX, y: startY } = this.#start;
    const place = { x: startX + wholePixels(x - startX), y: startY + wholePixels(y - startY), k };
    const effect = this.#animation?.effect as KeyframeEffect | undefined;
    effect?.setKeyframes(keyframes(place));
  }
}

/** The nearest distance in whole pixels of the screen; in pixels of the page. */
const wholePixels = (px: number): number => Math.round(px * devicePixelRatio) / devicePixelRatio;

function keyframes({ x, y, k }: View): PropertyIndexedKeyframes {
  const transform = `translate(${x}px, ${y}px) scale(${k})`;
  return { transform: [transform, transform] };
}
