import type { Protocol } from './mapping.ts';
import { readMappingFile } from './read-mapping-file.ts';
import type { MappingFile } from './read-mapping-file.ts';

/** Mappings of a bridge without a file. */
export const EMPTY_FILE = '{\n  "version": 1,\n  "mappings": []\n}\n';

/** A mapping file as it is written, and what it means. */
export interface MappingDocument {
  readonly text: string;
  readonly file: MappingFile;
  /** Its mappings as they are written. */
  readonly written: readonly unknown[];
}

/** @throws MappingError when it is wrong */
export function readDocument(text: string, protocol: Protocol): MappingDocument {
  const file = readMappingFile(text, protocol);
  const { mappings } = JSON.parse(text) as { readonly mappings: readonly unknown[] };
  return { text, file, written: mappings };
}

/**
 * The file with other mappings. Its other members, their order and its indentation stay; each member of a mapping gets a line of
 * its own. [BR-83]
 */
export function withMappings(text: string, mappings: readonly unknown[]): string {
  const json = JSON.parse(text) as object;
  return `${JSON.stringify({ ...json, mappings }, null, indentOf(text))}\n`;
}

/** That of the first line that has one; 2 spaces for a file on one line. */
function indentOf(text: string): string {
  const [, indent = '  '] = /\n([ \t]{1,8})\S/.exec(text) ?? [];
  return indent;
}
