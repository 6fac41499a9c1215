import type { Point } from '../../model/graph.ts';
import type { CanvasStage } from '../canvas-stage.ts';

/** Width of the zone along the edges that pans the canvas, pixels, and its highest speed, pixels per frame. */
const ZONE_PX = 28;
const MAX_STEP_PX = 16;

/** Returns the pan distance per frame for a pointer position along one axis, pixels. */
export function edgeStep(place: number, width: number): number {
  const before = ZONE_PX - place;
  const behind = place - (width - ZONE_PX);
  const depth = Math.max(before, behind);
  if (depth <= 0) return 0;
  const step = Math.min(1, depth / ZONE_PX) * MAX_STEP_PX;
  return before > 0 ? step : -step;
}

/** Pans the canvas while something is dragged to its edge. */
export class EdgePan {
  readonly #stage: CanvasStage;
  readonly #moved: (event: PointerEvent) => void;
  #event: PointerEvent | undefined;
  /** A drag that starts near the edge pans only after the pointer has been inside. */
  #hasBeenInside = false;
  #frame: number | undefined;

  /** @param moved called after the canvas moved under the pointer */
  constructor(stage: CanvasStage, moved: (event: PointerEvent) => void) {
    this.#stage = stage;
    this.#moved = moved;
  }

  update(event: PointerEvent): void {
    this.#event = event;
    const { x, y } = this.#step(event);
    if (x === 0 && y === 0) this.#hasBeenInside = true;
    else if (this.#hasBeenInside) this.#frame ??= requestAnimationFrame(() => this.#go());
  }

  stop(): void {
    if (this.#frame !== undefined) cancelAnimationFrame(this.#frame);
    this.#frame = undefined;
    this.#event = undefined;
    this.#hasBeenInside = false;
  }

  #step({ clientX, clientY }: PointerEvent): Point {
    const { left, top, width, height } = this.#stage.container.getBoundingClientRect();
    return { x: edgeStep(clientX - left, width), y: edgeStep(clientY - top, height) };
  }

  #go(): void {
    this.#frame = undefined;
    const event = this.#event;
    if (event === undefined) return;
    void this.#stage.pan(this.#step(event)).then(() => {
      // The drag may have ended in the meantime.
      if (this.#event !== undefined) this.#moved(this.#event);
    });
  }
}
