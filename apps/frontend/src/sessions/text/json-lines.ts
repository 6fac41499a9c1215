/** Lines of the members in a JSON text, or the reason why it is invalid. */
export type JsonLines =
  | {
      readonly kind: 'read';
      /** Line of a member by its path, such as `ioMappings[0].inputMappings[1].topic`; from 1. */
      lineOf(path: string): number | undefined;
    }
  | {
      readonly kind: 'broken';
      readonly line: number;
      readonly column: number;
      readonly message: string;
    };

class Broken extends Error {
  readonly at: number;
  constructor(at: number, message: string) {
    super(message);
    this.at = at;
  }
}

const NUMBER = /-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;
const STRING = /"(?:[ !#-[\]-\uffff]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"/y;
const SPACE = /[ \t\r\n]*/y;
const WORDS = ['true', 'false', 'null'] as const;

/** Scans a JSON text for line numbers; `JSON.parse` provides the values. */
class Reader {
  readonly places = new Map<string, number>();
  readonly #text: string;
  #at = 0;

  constructor(text: string) {
    this.#text = text;
  }

  document(): void {
    this.#space();
    if (this.#at === this.#text.length) throw new Broken(0, 'The text is empty.');
    this.#value('');
    this.#space();
    if (this.#at < this.#text.length) {
      throw new Broken(this.#at, `Expected the end of the text, found ${this.#here()}.`);
    }
  }

  #value(path: string): void {
    this.#space();
    this.places.set(path, this.#at);
    const sign = this.#text[this.#at];
    if (sign === '{') this.#object(path);
    else if (sign === '[') this.#list(path);
    else if (sign === '"') this.#string();
    else if (this.#match(NUMBER) === undefined) this.#word();
  }

  #object(path: string): void {
    this.#at += 1;
    if (this.#skip('}')) return;
    do {
      this.#space();
      const at = this.#at;
      if (this.#text[at] !== '"') {
        throw new Broken(at, `Expected a name in quotes, found ${this.#here()}.`);
      }
      const name = this.#string();
      const inner = path === '' ? name : `${path}.${name}`;
      if (!this.#skip(':')) {
        throw new Broken(this.#at, `Expected a colon after "${name}", found ${this.#here()}.`);
      }
      this.#value(inner);
      // The line of a member is that of its name.
      this.places.set(inner, at);
    } while (this.#skip(','));
    if (!this.#skip('}')) {
      throw new Broken(this.#at, `Expected a comma or }, found ${this.#here()}.`);
    }
  }

  #list(path: string): void {
    this.#at += 1;
    if (this.#skip(']')) return;
    let index = 0;
    do {
      this.#value(`${path}[${index}]`);
      index += 1;
    } while (this.#skip(','));
    if (!this.#skip(']')) {
      throw new Broken(this.#at, `Expected a comma or ], found ${this.#here()}.`);
    }
  }

  #string(): string {
    const quoted = this.#match(STRING);
    if (quoted === undefined) {
      throw new Broken(
        this.#at,
        'The string does not end on its line, or contains an invalid escape.',
      );
    }
    return JSON.parse(quoted) as string;
  }

  #word(): void {
    const word = WORDS.find((one) => this.#text.startsWith(one, this.#at));
    if (word === undefined) {
      throw new Broken(this.#at, `Expected a value, found ${this.#here()}.`);
    }
    this.#at += word.length;
  }

  #here(): string {
    const rest = this.#text.slice(this.#at);
    if (rest === '') return 'the end of the text';
    return `"${/^[\w.$-]{1,20}|^[^]/.exec(rest)?.[0] ?? ''}"`;
  }

  #skip(sign: string): boolean {
    this.#space();
    if (this.#text[this.#at] !== sign) return false;
    this.#at += 1;
    return true;
  }

  #space(): void {
    this.#match(SPACE);
  }

  #match(pattern: RegExp): string | undefined {
    pattern.lastIndex = this.#at;
    const found = pattern.exec(this.#text)?.[0];
    if (found !== undefined) this.#at += found.length;
    return found;
  }
}

/** Determines the line numbers of a JSON text. */
export function jsonLines(text: string): JsonLines {
  const reader = new Reader(text);
  const lineAt = (at: number): number => text.slice(0, at).split('\n').length;
  try {
    reader.document();
  } catch (cause) {
    if (!(cause instanceof Broken)) throw cause;
    const column = cause.at - text.lastIndexOf('\n', cause.at - 1);
    return { kind: 'broken', line: lineAt(cause.at), column, message: cause.message };
  }
  return {
    kind: 'read',
    lineOf(path) {
      // A missing member is reported at the line of its parent.
      for (let rest = path; rest !== ''; rest = rest.replace(/(^|\.)[^.[]*$|\[\d+\]$/, '')) {
        const at = reader.places.get(rest);
        if (at !== undefined) return lineAt(at);
        if (!/[.[]/.test(rest)) break;
      }
      const at = path === '' ? undefined : reader.places.get('');
      return at === undefined ? undefined : lineAt(at);
    },
  };
}
