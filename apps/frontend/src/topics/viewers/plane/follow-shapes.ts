import type { PlaneShape } from './plane-shapes.ts';
import { isKeypoint } from './skeletons.ts';

/** Smallest intersection over union of boxes in consecutive records that count as the same. */
const MIN_OVERLAP = 0.2;
/** Time after which a missing box counts as a new one, milliseconds. */
const HOLD_MS = 2000;
/** Most boxes tracked. */
const MAX_TRACKS = 200;
/** Class names whose boxes get letters. */
const LETTERED: ReadonlySet<string> = new Set(['person']);
const LETTERS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ';

interface Track {
  readonly key: string;
  readonly letter: string | undefined;
  shape: PlaneShape;
  seenMs: number;
}

/**
 * Tracks shapes from record to record: a box keeps its key, and a person the letter, while it overlaps with its
 * previous position. Keypoints keep their names.
 */
export class ShapeTracker {
  #tracks: Track[] = [];
  #count = 0;

  /** @returns the same shapes in the same order, with stable keys, and letters for persons */
  follow(shapes: readonly PlaneShape[], nowMs: number): PlaneShape[] {
    this.#tracks = this.#tracks.filter(({ seenMs }) => nowMs - seenMs <= HOLD_MS);
    const known = matches(shapes, this.#tracks);
    const points = new Map<string, number>();
    const followed = shapes.map((shape) => {
      if (!shape.size) {
        if (!isKeypoint(shape)) return shape;
        const count = (points.get(shape.name) ?? 0) + 1;
        points.set(shape.name, count);
        return { ...shape, key: `${shape.name} ${count}` };
      }
      const track = known.get(shape) ?? this.#begin(shape, nowMs);
      track.shape = shape;
      track.seenMs = nowMs;
      const { key, letter } = track;
      return { ...shape, key, ...(letter === undefined ? {} : { letter }) };
    });
    if (this.#tracks.length > MAX_TRACKS) {
      this.#tracks = this.#tracks.sort((a, b) => b.seenMs - a.seenMs).slice(0, MAX_TRACKS);
    }
    return followed;
  }

  #begin(shape: PlaneShape, nowMs: number): Track {
    this.#count += 1;
    const taken = new Set(this.#tracks.map(({ letter }) => letter));
    const letter = LETTERED.has(shape.name)
      ? [...LETTERS].find((one) => !taken.has(one))
      : undefined;
    const track = { key: `box ${this.#count}`, letter, shape, seenMs: nowMs };
    this.#tracks.push(track);
    return track;
  }
}

/** Assigns shapes to tracks, one to one: pairs with the largest overlap first. */
function matches(shapes: readonly PlaneShape[], tracks: readonly Track[]): Map<PlaneShape, Track> {
  const pairs = shapes
    .flatMap((shape) =>
      tracks.map((track) => ({ shape, track, overlap: overlapOf(shape, track.shape) })),
    )
    .filter(({ overlap }) => overlap >= MIN_OVERLAP)
    .sort((a, b) => b.overlap - a.overlap);
  const found = new Map<PlaneShape, Track>();
  const used = new Set<Track>();
  for (const { shape, track } of pairs) {
    if (found.has(shape) || used.has(track)) continue;
    found.set(shape, track);
    used.add(track);
  }
  return found;
}

/** Intersection over union of two boxes of the same name, 0 to 1. */
function overlapOf(a: PlaneShape, b: PlaneShape): number {
  if (a.name !== b.name || !a.size || !b.size) return 0;
  const width = Math.min(a.x + a.size.width, b.x + b.size.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.size.height, b.y + b.size.height) - Math.max(a.y, b.y);
  if (width <= 0 || height <= 0) return 0;
  const both = width * height;
  return both / (a.size.width * a.size.height + b.size.width * b.size.height - both);
}
