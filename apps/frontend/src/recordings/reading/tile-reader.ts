import type { RecordsReader } from '@ubii/recording';
import { entryOf, type TrackEntry } from '../timeline/track-entry.ts';
import type { TileRequest } from '../timeline/tile-store.ts';
import { TileBuilder, tileGrid, type Tile } from '../timeline/tile.ts';
import { decodeRecorded } from './decode-recorded.ts';
import type { ReadTurn } from './read-turns.ts';
import { TimeBase } from './recording-time-base.ts';

const NOTHING: Pick<TrackEntry, 'numbers'> = { numbers: [] };

/**
 * Reads the tiles of a request, in the order of time.
 *
 * @param isWanted asked between records; reading ends when it is false
 */
export async function readTiles(
  reader: RecordsReader,
  { topics, level, first, last }: TileRequest,
  { turn, isWanted }: { readonly turn: ReadTurn; readonly isWanted: () => boolean },
  onTile: (topic: string, index: number, tile: Tile) => void,
): Promise<void> {
  const base = new TimeBase(reader.summary.startNs);
  for (let index = first; index <= last && isWanted(); index++) {
    const grid = tileGrid(level, index);
    const builders = new Map(topics.map((topic) => [topic, new TileBuilder(grid)]));
    const query = {
      topics,
      fromNs: base.toNs(grid.fromMs),
      untilNs: base.toNs(grid.fromMs + grid.bucketMs * grid.buckets),
    };
    for await (const { topic, record, logTimeNs } of reader.records(query)) {
      const giveWay = turn.next();
      if (giveWay !== undefined) await giveWay;
      if (!isWanted()) return;
      const decoded = decodeRecorded(topic, record);
      builders.get(topic)?.add(base.toMs(logTimeNs), decoded ? entryOf(decoded) : NOTHING);
    }
    for (const [topic, builder] of builders) onTile(topic, index, builder.tile(true));
  }
}
