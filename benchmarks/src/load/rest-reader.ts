const NOTHING = Buffer.alloc(0);

/** Cuts a stream into messages, and keeps the beginning of one until the rest of it comes. */
export abstract class RestReader {
  #rest: Buffer = NOTHING;

  /** True when every byte pushed so far belonged to a whole message. */
  get isAtBoundary(): boolean {
    return this.#rest.length === 0;
  }

  /** Takes the next bytes of the stream. They are borrowed; an incomplete message at the end is copied. */
  push(chunk: Buffer): void {
    const bytes = this.#rest.length === 0 ? chunk : Buffer.concat([this.#rest, chunk]);
    const end = this.readMessages(bytes);
    this.#rest = end === bytes.length ? NOTHING : Buffer.from(bytes.subarray(end));
  }

  /** Reads the messages that are whole. @returns where the last of them ends */
  protected abstract readMessages(bytes: Buffer): number;
}
