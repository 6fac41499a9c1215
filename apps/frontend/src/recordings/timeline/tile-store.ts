import type { Span } from './span.ts';
import { levelOf, tileGrid, tilesOf, type Tile } from './tile.ts';

/** Who shows tiles: a new request of a view takes the place of its last one. */
export type TileViewer = 'timeline' | 'inspector' | 'stage';

/** Tiles of one level that are to be read, of several topics. */
export interface TileRequest {
  readonly viewer: TileViewer;
  readonly topics: readonly string[];
  readonly level: number;
  /** The first and the last one, by number. */
  readonly first: number;
  readonly last: number;
}

/** A tile as far as it is drawn: the part that no finer one covers. */
export interface TilePiece extends Span {
  readonly tile: Tile;
}

/** Tiles kept: an hour of sixty tracks at one level, about. */
const MAX_TILES = 3000;

/**
 * Tiles of tracks, finer ones where they were read, of the whole recording where not. Those that were not drawn for
 * longest go first.
 */
export class TileStore {
  readonly #tiles = new Map<string, Tile>();
  /** Of the whole recording, by topic. */
  #whole: ReadonlyMap<string, Tile> = new Map();
  readonly #requested = new Map<TileViewer, string>();
  readonly #request: (request: TileRequest) => void;

  constructor(request: (request: TileRequest) => void) {
    this.#request = request;
  }

  /** Takes what is known of all tracks over all of the time. */
  setWhole(tiles: ReadonlyMap<string, Tile>): void {
    this.#whole = tiles;
  }

  take(topic: string, level: number, index: number, tile: Tile): void {
    const key = keyOf(topic, level, index);
    this.#tiles.delete(key);
    this.#tiles.set(key, tile);
    for (const oldest of this.#tiles.keys()) {
      if (this.#tiles.size <= MAX_TILES) return;
      this.#tiles.delete(oldest);
    }
  }

  /** Asks for the tiles that tracks in view lack. */
  want(viewer: TileViewer, topics: readonly string[], span: Span, msPerPx: number): void {
    const level = levelOf(msPerPx);
    const { first, last } = tilesOf(level, span);
    const lacking = topics.filter(
      (topic) => !this.#isFineEnough(topic, level) && this.#lacks(topic, level, first, last),
    );
    const key = `${level} ${first} ${last} ${lacking.join(' ')}`;
    if (lacking.length === 0 || key === this.#requested.get(viewer)) return;
    this.#requested.set(viewer, key);
    this.#request({ viewer, topics: lacking, level, first, last });
  }

  /** What is drawn of a track in a span, in the order of time. */
  pieces(topic: string, span: Span, msPerPx: number): TilePiece[] {
    const level = levelOf(msPerPx);
    const whole = this.#whole.get(topic);
    if (this.#isFineEnough(topic, level)) return whole ? [{ tile: whole, ...span }] : [];
    const pieces: TilePiece[] = [];
    const { first, last } = tilesOf(level, span);
    for (let index = first; index <= last; index++) {
      const tile = this.#tiles.get(keyOf(topic, level, index)) ?? whole;
      if (tile === undefined) continue;
      const { fromMs, bucketMs, buckets } = tileGrid(level, index);
      pieces.push({
        tile,
        fromMs: Math.max(fromMs, span.fromMs),
        untilMs: Math.min(fromMs + bucketMs * buckets, span.untilMs),
      });
    }
    return pieces;
  }

  /** Whether the tile of the whole recording has the detail of a level. */
  #isFineEnough(topic: string, level: number): boolean {
    const whole = this.#whole.get(topic);
    return whole !== undefined && whole.grid.bucketMs <= 2 ** level * 1.01;
  }

  #lacks(topic: string, level: number, first: number, last: number): boolean {
    for (let index = first; index <= last; index++) {
      if (this.#tiles.get(keyOf(topic, level, index))?.isWhole !== true) return true;
    }
    return false;
  }
}

const keyOf = (topic: string, level: number, index: number): string => `${level} ${index} ${topic}`;
