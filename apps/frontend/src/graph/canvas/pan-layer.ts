/** How long a pan rests before it has ended, milliseconds. */
const REST_MS = 200;

/**
 * Makes what is panned a layer of its own, which browsers move without drawing it anew. That alone
 * saves the painting; Chromium still puts all layers together again in each frame, which takes longer
 * than everything else in it when there are hundreds of nodes. It does not where the transform is
 * animated, so that a pan is an animation that stands still, at one place after the other.
 */
export class PanLayer {
  readonly #element: HTMLElement;
  #animation: Animation | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(element: HTMLElement) {
    this.#element = element;
  }

  /** The element was moved: it is a layer from now on, until it has rested for a while. */
  hold(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.release(), REST_MS);
    this.#element.style.willChange = 'transform';
    if (this.#animation === undefined) {
      // Browsers without it move it by its style.
      this.#animation = this.#element.animate?.(this.#keyframes(), { duration: 1, fill: 'both' });
      this.#animation?.pause();
    } else this.follow();
  }

  /** Its style has another transform: while it is a layer, it goes there. */
  follow(): void {
    const effect = this.#animation?.effect as KeyframeEffect | undefined;
    effect?.setKeyframes(this.#keyframes());
  }

  /** It is drawn together with all else again, sharply. */
  release(): void {
    clearTimeout(this.#timer);
    this.#animation?.cancel();
    this.#animation = undefined;
    this.#element.style.willChange = '';
  }

  #keyframes(): PropertyIndexedKeyframes {
    const { transform } = this.#element.style;
    return { transform: [transform, transform] };
  }
}
