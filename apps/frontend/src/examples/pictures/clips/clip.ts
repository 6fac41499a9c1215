/** A moving picture that the page draws. */
export interface Clip {
  /** Draws a frame. */
  draw(canvas: HTMLCanvasElement, timeMs: number): void;
  /** Releases the bitmaps. */
  close?(): void;
}
