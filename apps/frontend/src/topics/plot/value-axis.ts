import type { NumberRange } from '../values/format-value.ts';

/** Margin above and below the lines, as a share of the range. */
const MARGIN = 0.08;
/** The axis shrinks when the values need less than this share of it, */
const CLOSE_IN_BELOW = 0.5;
/** for this long, milliseconds: a short quiet period does not change the scale. */
const CLOSE_IN_AFTER_MS = 2000;

/** Range of a value axis: grows at once and shrinks with a delay, so that lines keep their scale. */
export class ValueAxis {
  #range: NumberRange | undefined;
  /** The values in the range, without the margin. */
  #held: NumberRange | undefined;
  #roomySinceMs: number | undefined;

  /** @param values range in the window; `undefined` when it is empty */
  follow(values: NumberRange | undefined, nowMs: number): NumberRange {
    if (values === undefined) return this.#range ?? { min: -1, max: 1 };
    const range = this.#range;
    if (range === undefined || values.min < range.min || values.max > range.max) {
      this.#roomySinceMs = undefined;
      return this.#hold(range && this.#isSimilar(range, values) ? this.#heldWith(values) : values);
    }
    const isRoomy = values.max - values.min < CLOSE_IN_BELOW * (range.max - range.min);
    this.#roomySinceMs = isRoomy ? (this.#roomySinceMs ?? nowMs) : undefined;
    if (this.#roomySinceMs === undefined || nowMs - this.#roomySinceMs < CLOSE_IN_AFTER_MS) {
      return range;
    }
    this.#roomySinceMs = undefined;
    const closer = withMargin(values);
    const isCloser = closer.max - closer.min < range.max - range.min;
    return isCloser ? this.#hold(values) : range;
  }

  #hold(values: NumberRange): NumberRange {
    this.#held = values;
    return (this.#range = withMargin(values));
  }

  #heldWith({ min, max }: NumberRange): NumberRange {
    const held = this.#held ?? { min, max };
    return { min: Math.min(held.min, min), max: Math.max(held.max, max) };
  }

  /** True when the values exceed the axis slightly, instead of being in a different range. */
  #isSimilar(range: NumberRange, values: NumberRange): boolean {
    return values.min <= range.max && values.max >= range.min;
  }
}

/** Adds the margin; a single value is centred in a range of its own magnitude. */
function withMargin({ min, max }: NumberRange): NumberRange {
  const span = max - min;
  const room = span > 0 ? span * MARGIN : Math.max(Math.abs(max) * 0.1, 0.5);
  return { min: min - room, max: max + room };
}
