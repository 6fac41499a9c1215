/** How often values are drawn while the canvas rests, Hz. */
export const RESTING_HZ = 6;
/**
 * In how many frames all values are drawn once while the canvas is moved: half a second. To draw all of
 * them in one frame takes longer than a frame when there are hundreds; nobody reads them as they fly by.
 */
const MOVING_FRAMES = 30;

/** Says which of many values are drawn in a frame. */
export class DrawPace {
  #next = 0;
  #drawnMs = -Infinity;

  /**
   * @param names of all values
   * @returns all of them, none, or a few while the canvas is moved; each has its turn
   */
  take(names: readonly string[], nowMs: number, isMoving: boolean): readonly string[] {
    if (!isMoving) {
      if (nowMs - this.#drawnMs < 1000 / RESTING_HZ) return [];
      this.#drawnMs = nowMs;
      return names;
    }
    if (this.#next >= names.length) this.#next = 0;
    const start = this.#next;
    this.#next += Math.ceil(names.length / MOVING_FRAMES);
    return names.slice(start, this.#next);
  }
}
