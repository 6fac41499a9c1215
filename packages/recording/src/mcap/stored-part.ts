import { Opcode, type AttachmentIndex, type MetadataIndex } from '@mcap/core';

import { RecordingError } from '../records/recording-error.ts';
import type { RecordingSource } from '../storage/recording-storage.ts';
import type { FileIndex } from './file-index.ts';

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

/** Reads the last metadata record of a name; empty when there is none. @throws RecordingError when it is broken */
export async function readMetadata(
  source: RecordingSource,
  index: FileIndex,
  name: string,
): Promise<ReadonlyMap<string, string>> {
  const entry = index.metadata.findLast((candidate) => candidate.name === name);
  if (entry === undefined) return new Map();
  const record = await source.read(entry.offset, entry.length);
  try {
    return parseMetadata(record.subarray(Number(RECORD_HEAD_BYTES)));
  } catch (cause) {
    throw new RecordingError(`The metadata "${name}" is broken.`, { cause });
  }
}

/** The name and the size of the map in bytes, then keys and values: texts with their lengths before them. */
function parseMetadata(content: Uint8Array): Map<string, string> {
  const view = new DataView(content.buffer, content.byteOffset, content.byteLength);
  const decoder = new TextDecoder();
  let pos = 0;
  const text = (): string => {
    const start = pos + 4;
    pos = start + view.getUint32(pos, true);
    return decoder.decode(content.subarray(start, pos));
  };
  text();
  pos += 4;
  const metadata = new Map<string, string>();
  while (pos < content.length) metadata.set(text(), text());
  return metadata;
}
