import { readGesture, type Gesture } from './gesture/gesture.ts';
import { randomUuid } from '../connection/random-uuid.ts';

/** A named record, stored in this browser. */
export interface Snippet {
  readonly id: string;
  readonly name: string;
  /** The record as JSON text, with its variables. */
  readonly text: string;
  /** Records per second when it was saved. */
  readonly rateHz: number;
  /** The recorded gesture. */
  readonly gesture?: Gesture;
}

export const MAX_SNIPPETS = 200;
const KIND = 'ubii-publish-snippets';
const MAX_NAME = 120;

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
    text: JSON.stringify({ kind: KIND, version: 1, snippets }, null, 2),
  };
}

/** Returns the snippets in a file. @throws Error if it is not a snippet file */
export function readSnippets(text: string): Snippet[] {
  let file: unknown;
  try {
    file = JSON.parse(text);
  } catch {
    throw new Error('The file is not valid JSON.');
  }
  const { kind, snippets } = (file ?? {}) as { kind?: unknown; snippets?: unknown };
  if (kind !== KIND || !Array.isArray(snippets)) throw new Error('The file contains no snippets.');
  return snippets.slice(0, MAX_SNIPPETS).flatMap((one) => readSnippet(one) ?? []);
}

/** Returns undefined for an entry that is not a snippet, such as one of another version. */
export function readSnippet(value: unknown): Snippet | undefined {
  const { name, text, rateHz, ...rest } = (value ?? {}) as Record<string, unknown>;
  if (typeof name !== 'string' || name === '' || typeof text !== 'string') return undefined;
  const rate = typeof rateHz === 'number' && Number.isFinite(rateHz) ? rateHz : 1;
  const gesture = readGesture(rest['gesture']);
  const kept = { id: randomUuid(), name: name.slice(0, MAX_NAME), text, rateHz: rate };
  return gesture ? { ...kept, gesture } : kept;
}
