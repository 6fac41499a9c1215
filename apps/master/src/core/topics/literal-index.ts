import type { RequiredLiteral } from './required-literal.ts';

/** Characters of the pieces by which literals are found inside of texts. Shorter literals are not indexed. */
const PIECE_LENGTH = 3;

/**
 * Finds the items whose literal may be in a text without a look at each item: in time that grows with the length of the
 * text and the number of different lengths of prefixes.
 */
export class LiteralIndex<T> {
  /** Items by their prefix, by its length. */
  readonly #byPrefix = new Map<number, Map<string, Set<T>>>();
  /** Items by one piece of their literal. */
  readonly #byPiece = new Map<string, Set<T>>();
  readonly #withoutLiteral = new Set<T>();

  /** @param literal the same as in `delete` */
  add(item: T, literal: RequiredLiteral | undefined): void {
    if (literal === undefined || literal.text.length < PIECE_LENGTH) this.#withoutLiteral.add(item);
    else if (literal.isPrefix) this.#addPrefix(item, literal.text);
    else addTo(this.#byPiece, this.#rarestPiece(literal.text), item);
  }

  delete(item: T, literal: RequiredLiteral | undefined): void {
    this.#withoutLiteral.delete(item);
    if (literal === undefined) return;
    const { text } = literal;
    const prefixes = this.#byPrefix.get(text.length);
    if (prefixes !== undefined) {
      deleteFrom(prefixes, text, item);
      if (prefixes.size === 0) this.#byPrefix.delete(text.length);
    }
    for (const piece of piecesOf(text)) deleteFrom(this.#byPiece, piece, item);
  }

  /** Items whose literal the text may contain, and those without a literal. Some of them are wrong, none is missing. */
  candidates(text: string): Set<T> {
    const found = new Set(this.#withoutLiteral);
    for (const [length, prefixes] of this.#byPrefix) {
      if (length > text.length) continue;
      for (const item of prefixes.get(text.slice(0, length)) ?? []) found.add(item);
    }
    if (this.#byPiece.size === 0) return found;
    for (const piece of piecesOf(text)) {
      for (const item of this.#byPiece.get(piece) ?? []) found.add(item);
    }
    return found;
  }

  #addPrefix(item: T, text: string): void {
    let prefixes = this.#byPrefix.get(text.length);
    if (prefixes === undefined) this.#byPrefix.set(text.length, (prefixes = new Map()));
    addTo(prefixes, text, item);
  }

  /** Literals have pieces in common: those of devices all contain `/devices/`. */
  #rarestPiece(text: string): string {
    const countOf = (piece: string): number => this.#byPiece.get(piece)?.size ?? 0;
    return piecesOf(text).reduce((best, piece) => (countOf(piece) < countOf(best) ? piece : best));
  }
}

function piecesOf(text: string): string[] {
  const count = Math.max(0, text.length - PIECE_LENGTH + 1);
  return Array.from({ length: count }, (_, i) => text.slice(i, i + PIECE_LENGTH));
}

function addTo<T>(sets: Map<string, Set<T>>, key: string, item: T): void {
  const set = sets.get(key);
  if (set === undefined) sets.set(key, new Set([item]));
  else set.add(item);
}

function deleteFrom<T>(sets: Map<string, Set<T>>, key: string, item: T): void {
  const set = sets.get(key);
  set?.delete(item);
  if (set?.size === 0) sets.delete(key);
}
