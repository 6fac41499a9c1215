import * as v from 'valibot';
import { randomUuid } from '../connection/random-uuid.ts';
import { readImported, type Imported } from '../json/read-imported.ts';
import { storedAs } from '../json/read-stored.ts';
import { finite, maybe, validElements } from '../json/schemas.ts';
import { GESTURE, type Gesture } from './gesture/gesture.ts';

/** A named record, stored in this browser. */
export interface Snippet {
  readonly id: string;
  readonly name: string;
  /** The record as JSON text, with its variables. */
  readonly text: string;
  /** Records per second when it was saved. */
  readonly rateHz: number;
  /** The recorded gesture. */
  readonly gesture?: Gesture | undefined;
}

export const MAX_SNIPPETS = 200;
const KIND = 'ubii-publish-snippets';
const VERSION = 1;
const MAX_NAME = 120;
/** Longest file, characters; browsers store less. */
const MAX_FILE = 20_000_000;

/** Adds a snippet, or replaces the one of the same name. */
export function withSnippet(
  snippets: readonly Snippet[],
  name: string,
  text: string,
  rateHz: number,
  gesture?: Gesture,
): Snippet[] {
  const before = snippets.find((snippet) => snippet.name === name);
  const next = {
    id: before?.id ?? randomUuid(),
    name,
    text,
    rateHz,
    ...(gesture ? { gesture } : {}),
  };
  const rest = snippets.filter((snippet) => snippet !== before);
  return [next, ...rest].slice(0, MAX_SNIPPETS);
}

export function snippetsFile(snippets: readonly Snippet[]): { name: string; text: string } {
  return {
    name: 'snippets.json',
    text: JSON.stringify({ kind: KIND, version: VERSION, snippets }, null, 2),
  };
}

const SNIPPET = v.object({
  id: v.fallback(v.string(), () => randomUuid()),
  name: v.pipe(
    v.string(),
    v.minLength(1),
    v.transform((name) => name.slice(0, MAX_NAME)),
  ),
  text: v.string(),
  rateHz: v.fallback(finite, 1),
  gesture: maybe(GESTURE),
});
/** Drops invalid entries, such as those of another version. */
const SNIPPETS = validElements(SNIPPET, MAX_SNIPPETS);

/** Storage in this browser. */
export const storedSnippets = storedAs(SNIPPETS, []);

/** Returns the snippets in a file. */
export const readSnippets = (text: string): Imported<Snippet[]> =>
  readImported(
    { what: 'snippets', mark: ['kind', KIND], version: ['version', VERSION], maxChars: MAX_FILE },
    v.pipe(
      v.object({ snippets: SNIPPETS }),
      v.transform(({ snippets }) => snippets),
    ),
    text,
  );
