/**
 * Writes lines, of which those before `open()` wait for it: what the program does while it starts must not stand
 * above what it tells the person who started it.
 */
export class LinesAfter {
  readonly #write: (line: string) => void;
  #waiting: string[] | undefined = [];

  constructor(write: (line: string) => void) {
    this.#write = write;
  }

  write(line: string): void {
    if (this.#waiting === undefined) this.#write(line);
    else this.#waiting.push(line);
  }

  /** Writes what waited, in order. */
  open(): void {
    const waiting = this.#waiting ?? [];
    this.#waiting = undefined;
    for (const line of waiting) this.#write(line);
  }
}
