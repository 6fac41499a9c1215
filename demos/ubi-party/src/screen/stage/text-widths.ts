/** In the font of the names, at a size at which rounding does not matter. */
const SIZE_PX = 100;

/** Widths of texts as names are written, without asking the page for its layout. */
export class TextWidths {
  readonly #known = new Map<string, number>();
  readonly #context = document.createElement('canvas').getContext('2d');

  /** In font sizes. */
  of(text: string): number {
    let width = this.#known.get(text);
    if (width === undefined) {
      width = this.#measure(text);
      this.#known.set(text, width);
    }
    return width;
  }

  /** Measures again, such as when the font has come. */
  forget(): void {
    this.#known.clear();
  }

  #measure(text: string): number {
    // A browser without a canvas: as wide as its letters are on average
    if (!this.#context) return text.length * 0.55;
    this.#context.font = `700 ${SIZE_PX}px 'Bricolage Grotesque Variable', system-ui, sans-serif`;
    this.#context.fontStretch = 'semi-condensed';
    return this.#context.measureText(text).width / SIZE_PX;
  }
}
