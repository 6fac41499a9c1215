interface Edit {
  readonly at: number;
  readonly found: string;
  readonly put: string;
}

/** First places of characters, and places after their last ones. */
interface Places {
  readonly starts: Uint32Array;
  readonly ends: Uint32Array;
}

/** A text, and for each of its characters the part of the text that it was made of. */
export class MappedText {
  readonly text: string;
  /** Undefined while all characters stand where they stood. */
  readonly #places: Places | undefined;

  private constructor(text: string, places: Places | undefined) {
    this.text = text;
    this.#places = places;
  }

  static of(text: string): MappedText {
    return new MappedText(text, undefined);
  }

  /** Place in the original of the beginning of a character. */
  startOf(index: number): number {
    return this.#places === undefined ? index : this.#places.starts[index]!;
  }

  /** Place in the original after the end of a character. */
  endOf(index: number): number {
    return this.#places === undefined ? index + 1 : this.#places.ends[index]!;
  }

  /** Replaces what a pattern finds. @returns itself when nothing changes */
  rewritten(pattern: RegExp, replace: (found: string) => string): MappedText {
    const edits: Edit[] = [];
    for (const { 0: found, index: at } of this.text.matchAll(pattern)) {
      const put = replace(found);
      if (put !== found) edits.push({ at, found, put });
    }
    if (edits.length === 0) return this;
    const text = this.#textWith(edits);
    const isMoved = edits.some(({ found, put }) => found.length !== put.length);
    return new MappedText(text, isMoved ? this.#placesWith(edits, text.length) : this.#places);
  }

  #textWith(edits: readonly Edit[]): string {
    const parts: string[] = [];
    let done = 0;
    for (const { at, found, put } of edits) {
      parts.push(this.text.slice(done, at), put);
      done = at + found.length;
    }
    parts.push(this.text.slice(done));
    return parts.join('');
  }

  #placesWith(edits: readonly Edit[], length: number): Places {
    const starts = new Uint32Array(length);
    const ends = new Uint32Array(length);
    let to = 0;
    let from = 0;
    const keepUntil = (end: number): void => {
      for (; from < end; from++, to++) {
        starts[to] = this.startOf(from);
        ends[to] = this.endOf(from);
      }
    };
    for (const { at, found, put } of edits) {
      keepUntil(at);
      const after = at + found.length;
      starts.fill(this.startOf(at), to, to + put.length);
      ends.fill(this.endOf(after - 1), to, to + put.length);
      to += put.length;
      from = after;
    }
    keepUntil(this.text.length);
    return { starts, ends };
  }
}
