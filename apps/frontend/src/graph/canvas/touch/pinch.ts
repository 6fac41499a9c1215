import type { Point } from '../../model/graph.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { limitZoom, type View } from '../stage-view.ts';

/** Limits within which two fingers that are put down and lifted count as a tap: milliseconds and pixels. */
const TAP_MS = 300;
const TAP_PX = 12;

/** Pinch with two fingers: the point between them stays between them. */
export class Pinch {
  readonly #stage: Pick<CanvasStage, 'container' | 'look' | 'view'>;
  readonly #tapped: () => void;
  #start:
    | { view: View; middle: Point; distance: number; timeMs: number; moved: number }
    | undefined;

  /** @param tapped called when both fingers tapped */
  constructor(stage: Pick<CanvasStage, 'container' | 'look' | 'view'>, tapped: () => void) {
    this.#stage = stage;
    this.#tapped = tapped;
  }

  get isOn(): boolean {
    return this.#start !== undefined;
  }

  begin(fingers: readonly Point[], timeMs: number): void {
    const { middle, distance } = this.#look(fingers);
    this.#start = { view: { ...this.#stage.view.value }, middle, distance, timeMs, moved: 0 };
  }

  move(fingers: readonly Point[]): void {
    const start = this.#start;
    if (start === undefined || fingers.length < 2) return;
    const { middle, distance } = this.#look(fingers);
    const away = Math.hypot(middle.x - start.middle.x, middle.y - start.middle.y);
    start.moved = Math.max(start.moved, away, Math.abs(distance - start.distance));
    if (start.moved <= TAP_PX) return;
    void this.#stage.look(pinched(start.view, start.middle, middle, distance / start.distance));
  }

  end(timeMs: number): void {
    const start = this.#start;
    this.#start = undefined;
    if (start && start.moved <= TAP_PX && timeMs - start.timeMs < TAP_MS) this.#tapped();
  }

  #look([a = { x: 0, y: 0 }, b = a]: readonly Point[]): { middle: Point; distance: number } {
    const { left, top } = this.#stage.container.getBoundingClientRect();
    return {
      middle: { x: (a.x + b.x) / 2 - left, y: (a.y + b.y) / 2 - top },
      distance: Math.max(1, Math.hypot(a.x - b.x, a.y - b.y)),
    };
  }
}

/**
 * Returns the view after a pinch.
 * @param from initial point between the fingers
 * @param to current point between the fingers
 * @param by ratio of current to initial distance
 */
export function pinched(view: View, from: Point, to: Point, by: number): View {
  const k = limitZoom(view.k * by);
  const scale = k / view.k;
  return { k, x: to.x - (from.x - view.x) * scale, y: to.y - (from.y - view.y) * scale };
}
