import type { Mark, MarkColour, MarkShape } from '@ubii/proto';

/** Shapes, and colours: as many of each. */
const KINDS = 12;
/** Those that people choose among come first. */
const CHOICES = 8;

/** Assigns marks, so that people can tell clients apart. [EX-100] */
export class Marks {
  /** Clients with each mark, by shape and colour. */
  readonly #uses = new Uint32Array(KINDS * KINDS);
  readonly #shapeUses = new Uint32Array(KINDS);
  readonly #colourUses = new Uint32Array(KINDS);

  /** Mark of a client that would have `wanted`, and has `current` now. */
  decide(wanted: Mark | undefined, current: Mark | undefined): Mark {
    if (isMark(wanted) && (wanted.chosen || this.#uses[placeOf(wanted)] === 0)) return wanted;
    return current ?? this.free();
  }

  /** A mark that no client has: at first one whose shape and colour no client has; when all are taken, one that few have. */
  free(): Mark {
    for (let i = 0; i < CHOICES; i++) {
      if (this.#shapeUses[i] === 0 && this.#colourUses[i] === 0) return markAt(i, i);
    }
    return this.#leastUsed(CHOICES, 0) ?? this.#leastUsed(KINDS)!;
  }

  /** Counts a client with this mark, or with -1 one less. */
  count(mark: Mark | undefined, by: 1 | -1): void {
    if (!isMark(mark)) return;
    this.#uses[placeOf(mark)]! += by;
    this.#shapeUses[mark.shape - 1]! += by;
    this.#colourUses[mark.colour - 1]! += by;
  }

  /** @param most uses that it may have; `undefined` when there is none */
  #leastUsed(kinds: number, most = Number.POSITIVE_INFINITY): Mark | undefined {
    let best: Mark | undefined;
    let bestUses = most + 1;
    // Diagonals, so that neighbours differ in both.
    for (let apart = 0; apart < kinds; apart++) {
      for (let shape = 0; shape < kinds; shape++) {
        const mark = markAt(shape, (shape + apart) % kinds);
        const uses = this.#uses[placeOf(mark)]!;
        if (uses >= bestUses) continue;
        best = mark;
        bestUses = uses;
      }
    }
    return best;
  }
}

/** A mark as others see it. */
export function isMark(mark: Mark | undefined): mark is Mark {
  return mark !== undefined && isKind(mark.shape) && isKind(mark.colour);
}

function isKind(value: MarkShape | MarkColour): boolean {
  return value >= 1 && value <= KINDS;
}

function markAt(shape: number, colour: number): Mark {
  return { shape: (shape + 1) as MarkShape, colour: (colour + 1) as MarkColour, chosen: false };
}

/** A number for each pair. */
export function placeOf({ shape, colour }: Mark): number {
  return (shape - 1) * KINDS + colour - 1;
}
