import type { TrackEntry } from './track-entry.ts';

/** Where a tile lies: buckets of equal length, the first at `fromMs`. */
export interface TileGrid {
  readonly fromMs: number;
  readonly bucketMs: number;
  readonly buckets: number;
}

/** The lowest and highest number of each bucket; NaN where there is none. */
export interface TileLine {
  readonly low: Float32Array;
  readonly high: Float32Array;
}

/** What is drawn of one track in one stretch of time, at one level of detail. */
export interface Tile {
  readonly grid: TileGrid;
  /** Records of each bucket. */
  readonly counts: Uint32Array;
  readonly lines: readonly TileLine[];
  /** False while records of the stretch are still being read. */
  readonly isWhole: boolean;
}

/** Fills a tile record by record. */
export class TileBuilder {
  readonly #grid: TileGrid;
  readonly #counts: Uint32Array;
  readonly #lines: TileLine[] = [];

  constructor(grid: TileGrid) {
    this.#grid = grid;
    this.#counts = new Uint32Array(grid.buckets);
  }

  add(timeMs: number, { numbers }: Pick<TrackEntry, 'numbers'>): void {
    const { fromMs, bucketMs, buckets } = this.#grid;
    const bucket = Math.floor((timeMs - fromMs) / bucketMs);
    if (bucket < 0 || bucket >= buckets) return;
    this.#counts[bucket]! += 1;
    for (const [index, number] of numbers.entries()) {
      if (Number.isNaN(number)) continue;
      const { low, high } = (this.#lines[index] ??= this.#emptyLine());
      low[bucket] = Number.isNaN(low[bucket]!) ? number : Math.min(low[bucket]!, number);
      high[bucket] = Number.isNaN(high[bucket]!) ? number : Math.max(high[bucket]!, number);
    }
  }

  /** The tile so far, as a copy that can be given away. */
  tile(isWhole: boolean): Tile {
    const lines = Array.from(this.#lines, (line) => line ?? this.#emptyLine());
    return {
      grid: this.#grid,
      counts: this.#counts.slice(),
      lines: lines.map(({ low, high }) => ({ low: low.slice(), high: high.slice() })),
      isWhole,
    };
  }

  #emptyLine(): TileLine {
    const { buckets } = this.#grid;
    return {
      low: new Float32Array(buckets).fill(Number.NaN),
      high: new Float32Array(buckets).fill(Number.NaN),
    };
  }
}

/** Buckets of a tile. */
export const TILE_BUCKETS = 512;
/** Levels are powers of two: at level 0 a bucket is 1 ms long. Below this, single records are apart. */
const MIN_LEVEL = -4;

/** The level at which a bucket is at most as wide as a pixel. */
export function levelOf(msPerPx: number): number {
  return Math.max(MIN_LEVEL, Math.floor(Math.log2(msPerPx)));
}

export const tileLengthMs = (level: number): number => 2 ** level * TILE_BUCKETS;

export const tileGrid = (level: number, index: number): TileGrid => ({
  fromMs: index * tileLengthMs(level),
  bucketMs: 2 ** level,
  buckets: TILE_BUCKETS,
});

/** Which tiles of a level a span touches. */
export function tilesOf(
  level: number,
  span: { readonly fromMs: number; readonly untilMs: number },
): { readonly first: number; readonly last: number } {
  const length = tileLengthMs(level);
  return {
    first: Math.floor(span.fromMs / length),
    last: Math.max(Math.floor(span.fromMs / length), Math.ceil(span.untilMs / length) - 1),
  };
}
