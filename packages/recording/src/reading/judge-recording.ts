import { fromJson, type JsonObject, type PersonalLabel, type TextLimits } from '@ubii/proto';
import { hasMoreCharacters, isLongerThan } from '@ubii/words';
import { Opcode, type ChunkIndex } from '@mcap/core';

import type { FileIndex } from '../mcap/file-index.ts';
import { readMetadata } from '../mcap/stored-part.ts';
import { openFile } from '../mcap/open-file.ts';
import { RecordingError } from '../records/recording-error.ts';
import { headerFromMetadata, PROFILE } from '../records/recording-header.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import { ChannelChunks } from './channel-chunks.ts';
import { readEvents } from './recorded-events.ts';
import { StoredFile } from './stored-file.ts';
import { channelsOf } from './topics-of.ts';

/**
 * Checks the labels of personal data in the header of a file: one that is cut or left out would protect nothing.
 *
 * @throws RecordingError when they cannot be read, or there are too many or too long ones [RC-54]
 */
function checkLabels(personalData: string | undefined, limits: TextLimits): void {
  if (personalData === undefined) return;
  const labels = parseLabels(personalData);
  const { personalLabels } = limits;
  if (labels.length > personalLabels) {
    throw new RecordingError(
      `It has ${labels.length} labels of personal data, and a recording has at most ${personalLabels}.`,
    );
  }
  const place = labels.findIndex((label) => isTooLong(label, limits)) + 1;
  if (place > 0) throw new RecordingError(`Its label ${place} of personal data is too long.`);
}

function parseLabels(personalData: string): readonly PersonalLabel[] {
  try {
    return fromJson('ubii.extension.PersonalData', JSON.parse(personalData) as JsonObject).labels;
  } catch (cause) {
    throw new RecordingError('Its labels of personal data cannot be read.', { cause });
  }
}

function isTooLong(
  { id, topicPattern, fieldPath, note }: PersonalLabel,
  { idCharacters, topicBytes, identifierCharacters, descriptionCharacters }: TextLimits,
): boolean {
  return (
    hasMoreCharacters(id, idCharacters) ||
    isLongerThan(topicPattern, topicBytes) ||
    hasMoreCharacters(fieldPath, identifierCharacters) ||
    hasMoreCharacters(note, descriptionCharacters)
  );
}

/** What a recording may have. */
export interface RecordingLimits extends TextLimits {
  /** Markers, their changes included. [RC-23] */
  readonly markersPerRecording: number;
}

/** Decompressed bytes of chunks that are compared with their indexes, besides those of chunks with events. */
const MAX_COMPARED_BYTES = 256 * 1024 * 1024;
/** Opcode and length, times, decompressed size, checksum and length of the name of the compression. */
const HEAD_BYTES = 9 + 32;
const SIZE_BYTES = 8;

/**
 * Checks a file from elsewhere before it is taken: that its index says what its chunks hold, and that its events and labels
 * of personal data are what they should be. [RC-55]
 *
 * @throws RecordingError that says what is wrong, and where
 */
export async function judgeRecording(
  source: RecordingSource,
  limits: RecordingLimits,
): Promise<void> {
  const { index, source: whole } = await openFile(source);
  const header = headerFromMetadata(await readMetadata(whole, index, PROFILE));
  checkLabels(header.personalData, limits);
  const file = new StoredFile(whole, index);
  const { events: kinds } = channelsOf(index);
  let leftBytes = MAX_COMPARED_BYTES;
  for (const [place, chunk] of index.chunks.entries()) {
    const hasEvents = [...chunk.messageIndexOffsets.keys()].some((id) => kinds.has(id));
    if (!hasEvents) leftBytes -= Number(chunk.uncompressedSize);
    const lie =
      (await headLie(whole, chunk)) ??
      (hasEvents || leftBytes >= 0 ? await contentLie(file, chunk, index) : undefined);
    if (lie !== undefined) {
      throw new RecordingError(`The index of the file is wrong about chunk ${place + 1}: ${lie}.`);
    }
  }
  const { events, malformed } = await readEvents(file, new ChannelChunks(index.chunks), kinds);
  if (malformed !== undefined) throw new RecordingError(malformed.first);
  const markers = events.filter(({ kind }) => kind === 'marker').length;
  const { markersPerRecording } = limits;
  if (markers > markersPerRecording) {
    throw new RecordingError(
      `It has ${markers} markers, and a recording has at most ${markersPerRecording}.`,
    );
  }
}

/** What an index says of a chunk and its own head does not; undefined when there is nothing. */
async function headLie(source: RecordingSource, chunk: ChunkIndex): Promise<string | undefined> {
  const { chunkStartOffset, chunkLength, compression } = chunk;
  const name = new TextEncoder().encode(compression);
  const length = BigInt(HEAD_BYTES + name.length + SIZE_BYTES);
  if (chunkLength < length) return 'it is too short';
  const head = await source.read(chunkStartOffset, length);
  const view = new DataView(head.buffer, head.byteOffset, head.byteLength);
  if (head[0] !== Number(Opcode.CHUNK)) return 'it is not there';
  if (view.getBigUint64(1, true) + 9n !== chunkLength) return 'it has another length';
  const times = [view.getBigUint64(9, true), view.getBigUint64(17, true)];
  if (times[0] !== chunk.messageStartTime || times[1] !== chunk.messageEndTime) {
    return 'it has other times';
  }
  const isSame =
    view.getUint32(HEAD_BYTES - 4, true) === name.length &&
    name.every((byte, i) => head[HEAD_BYTES + i] === byte);
  if (!isSame) return 'it is compressed in another way';
  const isOfSize =
    view.getBigUint64(25, true) === chunk.uncompressedSize &&
    view.getBigUint64(HEAD_BYTES + name.length, true) === chunk.compressedSize;
  return isOfSize ? undefined : 'it has another size';
}

/** What an index says of a chunk and its messages do not; undefined when there is nothing. */
async function contentLie(
  file: StoredFile,
  chunk: ChunkIndex,
  { channels }: FileIndex,
): Promise<string | undefined> {
  const { messageStartTime, messageEndTime, messageIndexOffsets } = chunk;
  const { all } = await file.messagesOf(chunk);
  const isWithin = all.every(
    ({ logTimeNs }) => logTimeNs >= messageStartTime && logTimeNs <= messageEndTime,
  );
  if (!isWithin) return 'it has messages of other times';
  // Message indexes are optional.
  const known = messageIndexOffsets.size > 0 ? messageIndexOffsets : channels;
  return all.every(({ channelId }) => known.has(channelId) && channels.has(channelId))
    ? undefined
    : 'it has messages of other channels';
}
