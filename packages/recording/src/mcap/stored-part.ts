import { Opcode, type AttachmentIndex, type MetadataIndex } from '@mcap/core';
import { RecordingError } from '../records/recording-error.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';

/** An attachment or metadata of a file, as it is stored. */
export type StoredPart = {
  /** Reads the whole record in pieces, so that attachments of any size take little memory. @throws RecordingError when it is broken */
  pieces(): AsyncIterable<Uint8Array>;
} & (
  | { readonly kind: 'attachment'; readonly entry: AttachmentIndex }
  | { readonly kind: 'metadata'; readonly entry: MetadataIndex }
);

const PIECE_BYTES = 1024n * 1024n;
/** Opcode and length of the content. */
const RECORD_HEAD_BYTES = 9n;

export function storedAttachment(source: RecordingSource, entry: AttachmentIndex): StoredPart {
  return { kind: 'attachment', entry, pieces: () => piecesOf(source, Opcode.ATTACHMENT, entry) };
}

export function storedMetadata(source: RecordingSource, entry: MetadataIndex): StoredPart {
  return { kind: 'metadata', entry, pieces: () => piecesOf(source, Opcode.METADATA, entry) };
}

async function* piecesOf(
  source: RecordingSource,
  opcode: Opcode,
  { name, offset, length }: AttachmentIndex | MetadataIndex,
): AsyncGenerator<Uint8Array> {
  const end = offset + length;
  for (let at = offset; at < end; at += PIECE_BYTES) {
    const piece = await source.read(at, end - at < PIECE_BYTES ? end - at : PIECE_BYTES);
    if (at === offset && !isHead(piece, opcode, length)) {
      throw new RecordingError(`"${name}", which another program attached, is broken.`);
    }
    yield piece;
  }
}

/** Indexes of other programs may name any place. */
function isHead(bytes: Uint8Array, opcode: Opcode, length: bigint): boolean {
  if (length < RECORD_HEAD_BYTES) return false;
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  return (
    view.getUint8(0) === Number(opcode) && view.getBigUint64(1, true) === length - RECORD_HEAD_BYTES
  );
}
