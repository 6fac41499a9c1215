import type { PlaneShape } from './plane-shapes.ts';

/** Duration of the animation to a new position, milliseconds. */
export const FOLLOW_MS = 80;
/** Duration of fading out, milliseconds. */
export const VANISH_MS = 160;

interface Eased {
  from: PlaneShape;
  to: PlaneShape;
  sinceMs: number;
  /** Time at which it began to fade out. */
  goneMs: number | undefined;
}

/** Animates shapes to new positions, and fades out removed ones. Shapes are identified by their keys. */
export class ShapeEasing {
  #marks = new Map<string, Eased>();

  /** @param shapes current shapes */
  set(shapes: readonly PlaneShape[], nowMs: number): void {
    const next = new Map<string, Eased>();
    for (const to of shapes) {
      const before = this.#marks.get(to.key);
      const from = before && before.goneMs === undefined ? drawnAt(before, nowMs) : to;
      next.set(to.key, { from, to, sinceMs: nowMs, goneMs: undefined });
    }
    for (const [key, mark] of this.#marks) {
      if (next.has(key)) continue;
      const goneMs = mark.goneMs ?? nowMs;
      const still = mark.goneMs === undefined ? drawnAt(mark, nowMs) : mark.to;
      if (nowMs - goneMs < VANISH_MS) {
        next.set(key, { from: still, to: still, sinceMs: nowMs, goneMs });
      }
    }
    this.#marks = next;
  }

  /** Returns the shapes to draw at a time, and whether they still move. */
  at(nowMs: number): { readonly shapes: readonly PlaneShape[]; readonly isMoving: boolean } {
    let isMoving = false;
    const shapes: PlaneShape[] = [];
    for (const [key, mark] of this.#marks) {
      const { goneMs, sinceMs } = mark;
      if (goneMs !== undefined) {
        const left = 1 - (nowMs - goneMs) / VANISH_MS;
        isMoving = true;
        if (left > 0) shapes.push({ ...mark.to, opacity: left });
        else this.#marks.delete(key);
        continue;
      }
      if (nowMs - sinceMs < FOLLOW_MS) isMoving ||= mark.from !== mark.to;
      shapes.push(drawnAt(mark, nowMs));
    }
    return { shapes, isMoving };
  }
}

/** Ease-out: fast at first, slow at the end. */
function drawnAt({ from, to, sinceMs }: Eased, nowMs: number): PlaneShape {
  const passed = Math.min(1, Math.max(0, (nowMs - sinceMs) / FOLLOW_MS));
  if (passed === 1 || from === to) return to;
  const share = 1 - (1 - passed) ** 2;
  const between = (a: number, b: number): number => a + (b - a) * share;
  return {
    ...to,
    x: between(from.x, to.x),
    y: between(from.y, to.y),
    ...(from.size &&
      to.size && {
        size: {
          width: between(from.size.width, to.size.width),
          height: between(from.size.height, to.size.height),
        },
      }),
  };
}
