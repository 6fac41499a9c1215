import type { Point } from '../model/graph.ts';
import type { View } from './stage-view.ts';

/** Time without movement after which a pan has ended, milliseconds. */
const REST_MS = 200;

/**
 * Turns the panned element into a compositor layer, which browsers move without repainting.
 *
 * Done with a paused animation that is set to one position after the other: Chromium rebuilds all layers of a page
 * whenever the transform of one changes, unless it is animated. Not with `will-change`, with which Chromium paints
 * small content as large as at 100 % and scales it down in each frame. Moves by whole device pixels, otherwise each
 * frame is repainted.
 */
export class PanLayer {
  readonly #element: HTMLElement;
  #animation: Animation | undefined;
  /** Position when the layer was created, or zoomed last. */
  #start: Point = { x: 0, y: 0 };
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(element: HTMLElement) {
    this.#element = element;
  }

  /** The element was moved: it is a layer until it has rested for `REST_MS`. */
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

  /** The element was zoomed: updates the layer, if there is one. */
  follow(view: View): void {
    this.#start = view;
    this.#move(view);
  }

  /** Removes the layer: the element is painted with the rest of the page again. */
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

/** Rounds to whole device pixels; in CSS pixels. */
const wholePixels = (px: number): number => Math.round(px * devicePixelRatio) / devicePixelRatio;

function keyframes({ x, y, k }: View): PropertyIndexedKeyframes {
  const transform = `translate(${x}px, ${y}px) scale(${k})`;
  return { transform: [transform, transform] };
}
