import { Opcode } from '@mcap/core';
import { storedRecords } from '../mcap/salvage.ts';
import { unpackChunk } from '../mcap/unpack-chunk.ts';
import type { MemoryFile } from './memory-file.ts';

/** All bytes of a file, with its chunks decompressed. */
export async function contentOf(file: MemoryFile): Promise<Buffer> {
  const parts: Uint8Array[] = [file.bytes];
  for await (const { opcode, content } of storedRecords(file)) {
    if (opcode === Number(Opcode.CHUNK)) parts.push((await unpackChunk(content)).slice());
  }
  return Buffer.concat(parts);
}
