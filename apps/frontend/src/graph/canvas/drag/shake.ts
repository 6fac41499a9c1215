/** Turns that make a shake, each after a way of its own, all within a short time. */
const TURNS = 4;
const WAY_PX = 24;
const WITHIN_MS = 900;

/** Notices when something that is dragged is shaken from side to side. */
export class Shake {
  #turnX: number | undefined;
  #direction = 0;
  #turns: number[] = [];

  /** @param x of the pointer, pixels. @returns true when this made a shake of it */
  add(x: number, timeMs: number): boolean {
    if (this.#turnX === undefined) {
      this.#turnX = x;
      return false;
    }
    const way = x - this.#turnX;
    // On its way the farthest place counts, for there it may turn.
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
