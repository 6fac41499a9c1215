import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';

const KIB = 1024;
const MIB = 1024 * KIB;

/** Limits of what a reader takes from one file, whoever wrote it. Files beyond them are refused. [RC-43] */
export const READING_LIMITS = {
  /** Bytes of one read. The largest is a chunk that compression made no smaller, with its message indexes. */
  readBytes: 80 * MIB,
  /** Bytes of the index at the end: about a day with 100 topics. Each byte takes up to six in memory. */
  indexBytes: 64 * MIB,
  /** Bytes of a chunk when it is decompressed. Programs write 1 to 4 MiB, and one record more: at most 32 MiB. */
  chunkBytes: 64 * MIB,
  /** Messages in a chunk. Those of 1 MiB have up to 34 000; each is an object in memory. */
  chunkMessages: 500_000,
  /** Bytes of the header of a recording: its texts, its selection and 200 labels. */
  headerBytes: 4 * MIB,
  /** Markers, clients and gaps, which each opening reads: 100 000 take a second. A day with 100 clients that reconnect hourly has 5000. */
  openingEvents: 100_000,
  /** Events of all kinds. A day with 60 clients has up to 500 000 changes of clocks. */
  events: 500_000,
  /** Bytes of events that are read together. */
  eventBytes: 64 * MIB,
} as const;

/**
 * Checks a read before memory is taken for it: offsets and lengths come from files, which may state anything. [RC-43]
 *
 * @param size of the file
 * @throws RecordingError when the bytes are not in the file, or too many for one read
 */
export function expectReadable(offset: bigint, length: bigint, size: bigint): void {
  if (offset < 0n || length < 0n || offset + length > size) {
    throw new RecordingError('The file ends before these bytes.');
  }
  if (length > BigInt(READING_LIMITS.readBytes)) {
    throw new RecordingLimitError(
      `The file has a part of ${length} bytes. At most ${READING_LIMITS.readBytes} are read at once.`,
    );
  }
}
