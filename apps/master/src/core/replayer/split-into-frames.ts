import { encodeRecordListFrame } from '@ubii/proto/wire';

/** Most records of a frame: what a master publishes in one turn, about a millisecond. */
const FRAME_RECORDS = 500;
/** Bytes from which on a frame is full. */
const FRAME_BYTES = 1024 * 1024;

/** A record with its topic. */
export interface NamedRecord {
  readonly topic: string;
  readonly record: Uint8Array;
}

/** A message of topic data. */
export interface Frame {
  readonly frame: Uint8Array;
  readonly records: number;
  readonly topics: ReadonlySet<string>;
}

/** Puts records into frames, in their order, so that other work has its turn between them. */
export function* splitIntoFrames(records: readonly NamedRecord[]): Generator<Frame> {
  let start = 0;
  let bytes = 0;
  for (let index = 0; index < records.length; index++) {
    bytes += records[index]!.record.length;
    const end = index + 1;
    const isFull = end - start >= FRAME_RECORDS || bytes >= FRAME_BYTES;
    if (!isFull && end < records.length) continue;
    yield frameOf(records.slice(start, end));
    start = end;
    bytes = 0;
  }
}

function frameOf(records: readonly NamedRecord[]): Frame {
  return {
    frame: encodeRecordListFrame(records.map(({ record }) => record)),
    records: records.length,
    topics: new Set(records.map(({ topic }) => topic)),
  };
}
