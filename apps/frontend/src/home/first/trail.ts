/** Position on a pad; both axes 0 to 1, origin top left. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** Part of a trail; the last one ends at the newest position. */
export interface TrailPart {
  readonly path: string;
  readonly opacity: number;
}

/** Most positions of a trail. */
const MAX_PLACES = 48;
/** Parts, which fade towards the oldest one. */
const PARTS = 8;

/** Appends a position; the oldest ones are dropped. */
export function withPlace(trail: readonly Place[], place: Place): readonly Place[] {
  return [...trail, place].slice(-MAX_PLACES);
}

/** Returns the trail as lines on a pad of `size` units, oldest first. */
export function trailParts(trail: readonly Place[], size: number): readonly TrailPart[] {
  const steps = Math.ceil((trail.length - 1) / PARTS);
  const parts: TrailPart[] = [];
  for (let from = 0; from < trail.length - 1; from += steps) {
    const places = trail.slice(from, from + steps + 1);
    const points = places.map(({ x, y }) => `${(x * size).toFixed(1)} ${(y * size).toFixed(1)}`);
    const opacity = (from + places.length) / (trail.length + 1);
    parts.push({ path: `M${points.join('L')}`, opacity: Math.round(opacity * 100) / 100 });
  }
  return parts;
}
