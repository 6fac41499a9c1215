import type { Point, SpaceThing } from './space-things.ts';

/** Most points per trail, and most trails. */
export const MAX_TRAIL = 240;
export const MAX_TRAILS = 24;

/** Previous positions of objects. Bounded: the newest points of the first objects. */
export class Trails {
  readonly #points = new Map<string, Point[]>();

  /** Removes the trails of removed objects. */
  add(things: readonly SpaceThing[]): void {
    const here = new Set<string>();
    for (const { key, at } of things.slice(0, MAX_TRAILS)) {
      here.add(key);
      const points = this.#points.get(key) ?? [];
      this.#points.set(key, points);
      const last = points.at(-1);
      if (last && last.every((part, index) => part === at[index])) continue;
      points.push(at);
      if (points.length > MAX_TRAIL) points.shift();
    }
    for (const key of this.#points.keys()) if (!here.has(key)) this.#points.delete(key);
  }

  clear(): void {
    this.#points.clear();
  }

  /** Trails of objects that moved, by key, oldest point first. */
  get lines(): ReadonlyMap<string, readonly Point[]> {
    return new Map([...this.#points].filter(([, points]) => points.length > 1));
  }
}
