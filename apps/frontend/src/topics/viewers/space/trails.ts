import type { Point, SpaceThing } from './space-things.ts';

/** Points of one trail, and trails. */
export const MAX_TRAIL = 240;
export const MAX_TRAILS = 24;

/** Where things were before. Bounded: the newest points of the first things. */
export class Trails {
  readonly #points = new Map<string, Point[]>();

  /** A thing that is gone takes its trail along. */
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

  /** By key, oldest first; those that moved. */
  get lines(): ReadonlyMap<string, readonly Point[]> {
    return new Map([...this.#points].filter(([, points]) => points.length > 1));
  }
}
