import { RecordingError, RecordingLimitError } from '../records/recording-error.ts';
import { READING_LIMITS } from './reading-limits.ts';

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
