import type { Reader } from './reader.ts';
import type { TextCache } from './text-cache.ts';

/** Reads a text, from those remembered if there are any. */
export function readText(reader: Reader, texts: TextCache | undefined): string {
  if (texts === undefined) return reader.string();
  const length = reader.length();
  const start = reader.pos;
  reader.pos = start + length;
  return texts.read(reader.input, start, reader.pos);
}
