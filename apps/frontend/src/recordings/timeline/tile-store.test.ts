import { describe, expect, it } from 'vitest';
import { TileBuilder, tileGrid, tileLengthMs, type Tile } from './tile.ts';
import { TileStore, type TileRequest } from './tile-store.ts';

const WHOLE: Tile = new TileBuilder({ fromMs: 0, bucketMs: 100, buckets: 1000 }).tile(true);
const fine = (level: number, index: number): Tile =>
  new TileBuilder(tileGrid(level, index)).tile(true);

function setUp() {
  const requests: TileRequest[] = [];
  const store = new TileStore((request) => requests.push(request));
  store.setWhole(new Map([['/a', WHOLE]]));
  return { store, requests };
}

describe('tiles of a timeline', () => {
  it('of the whole recording are enough from afar', () => {
    const { store, requests } = setUp();
    const span = { fromMs: 0, untilMs: 100_000 };
    store.want('timeline', ['/a'], span, 130);
    expect(requests).toEqual([]);
    expect(store.pieces('/a', span, 130)).toEqual([{ tile: WHOLE, ...span }]);
  });

  it('are asked for once from near, and drawn coarsely until they come', () => {
    const { store, requests } = setUp();
    const length = tileLengthMs(0);
    const span = { fromMs: 100, untilMs: length + 200 };
    store.want('timeline', ['/a'], span, 1);
    store.want('timeline', ['/a'], span, 1);
    expect(requests).toEqual([{ viewer: 'timeline', topics: ['/a'], level: 0, first: 0, last: 1 }]);
    const tile = fine(0, 1);
    store.take('/a', 0, 1, tile);
    expect(store.pieces('/a', span, 1)).toEqual([
      { tile: WHOLE, fromMs: 100, untilMs: length },
      { tile, fromMs: length, untilMs: length + 200 },
    ]);
  });

  it('are not asked for again when they are there', () => {
    const { store, requests } = setUp();
    store.take('/a', 0, 0, fine(0, 0));
    store.want('timeline', ['/a'], { fromMs: 0, untilMs: 500 }, 1);
    expect(requests).toEqual([]);
  });
});
