/** How often values are drawn while the canvas rests, Hz. */
const RESTING_HZ = 6;
/** While it is moved: to draw hundreds takes longer than a frame, and nobody reads what flies by. */
const MOVING_HZ = 1;

/** Says in which frames the values on a canvas are drawn. */
export class DrawPace {
  #drawnMs = -Infinity;

  /** Whether it is time in this frame; if so, the next time is some frames later. */
  take(nowMs: number, isMoving: boolean): boolean {
    if (nowMs - this.#drawnMs < 1000 / (isMoving ? MOVING_HZ : RESTING_HZ)) return false;
    this.#drawnMs = nowMs;
    return true;
  }
}
