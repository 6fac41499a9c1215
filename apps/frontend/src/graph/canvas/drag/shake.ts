/** Number of direction changes, each after a minimum distance and all within a short time, that count as a shake. */
const TURNS = 4;
const WAY_PX = 24;
const WITHIN_MS = 900;

/** Detects that a dragged element is shaken from side to side. */
export class Shake {
  #turnX: number | undefined;
  #direction = 0;
  #turns: number[] = [];

  /** @param x of the pointer, pixels. @returns true when this position completes a shake */
  add(x: number, timeMs: number): boolean {
    if (this.#turnX === undefined) {
      this.#turnX = x;
      return false;
    }
    const way = x - this.#turnX;
    // While the direction is unchanged, the farthest position is the possible turning point.
    if (Math.sign(way) === this.#direction) {
      this.#turnX = x;
      return false;
    }
    if (Math.abs(way) < WAY_PX) return false;
    this.#turnX = x;
    this.#direction = Math.sign(way);
    this.#turns = [...this.#turns.filter((turn) => timeMs - turn < WITHIN_MS), timeMs];
    if (this.#turns.length <= TURNS) return false;
    this.#turns = [];
    return true;
  }
}
