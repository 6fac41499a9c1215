/** Widths in pixels: of a value axis at least, its gap to the plot, of the labels at least, and their gap and letter. */
const MIN_AXIS = 48;
const AXIS_GAP = 10;
const MIN_RIGHT = 48;
const LABEL_GAP = 12;
const LETTER = 30;
/** Widths are multiples of this, and shrink only by twice of it: a changing digit moves nothing. */
const STEP = 8;
const MAX = 140;

/** Widths of the value axes and end labels of a plot, from what is written in them. */
export class PlotSizes {
  readonly #character: number;
  readonly #axes = new Map<string, number>();
  #right = MIN_RIGHT;

  /** @param character width of a digit, pixels */
  constructor(character: number) {
    this.#character = character;
  }

  get right(): number {
    return this.#right;
  }

  /** @param texts on the axis; uPlot has none in its first pass */
  axis(scale: string, texts: readonly (string | number | null)[] | null): number {
    const characters = Math.max(0, ...(texts ?? []).map((text) => String(text ?? '').length));
    const width = steady(
      this.#axes.get(scale) ?? MIN_AXIS,
      Math.max(MIN_AXIS, characters * this.#character + AXIS_GAP),
    );
    this.#axes.set(scale, width);
    return width;
  }

  /** Widths of these axes, in their order; of one axis when there is none. */
  widths(scales: readonly string[]): readonly number[] {
    const all = scales.length === 0 ? ['y'] : scales;
    return all.map((scale) => this.#axes.get(scale) ?? MIN_AXIS);
  }

  /** @param characters of the widest value */
  fitLabels(characters: number, hasLetters: boolean): void {
    const needed = characters * this.#character + LABEL_GAP + (hasLetters ? LETTER : 0);
    this.#right = steady(this.#right, Math.max(MIN_RIGHT, needed));
  }
}

function steady(before: number, needed: number): number {
  const next = Math.min(MAX, Math.ceil(needed / STEP) * STEP);
  return next > before || next <= before - 2 * STEP ? next : before;
}

/** Width of a digit in a monospaced font, pixels. */
export function characterWidth(font: string): number {
  const on = document.createElement('canvas').getContext('2d');
  if (!on) return STEP;
  on.font = font;
  return on.measureText('0').width;
}
