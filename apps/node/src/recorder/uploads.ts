import { ServiceError } from '@ubii/proto';

/** What uploads work with. */
export interface UploadsContext {
  /** Sends a file. @throws when that fails */
  send(id: string, signal: AbortSignal, onProgress: (bytes: number) => void): Promise<void>;
  /** Its file is at the master. */
  handleSent(id: string): Promise<void>;
  /** Numbers or problems have changed. */
  onChange(): void;
}

/** Uploads one recording after the other, and remembers why one failed. [RC-63] */
export class Uploads {
  readonly #context: UploadsContext;
  readonly #problems = new Map<string, string>();
  readonly #waiting = new Set<string>();
  readonly #abort = new AbortController();
  #current: { readonly id: string; bytes: number } | undefined;
  #done: Promise<void> = Promise.resolve();

  constructor(context: UploadsContext) {
    this.#context = context;
  }

  /** Why it failed last; empty when it did not. */
  problemOf(id: string): string {
    return this.#problems.get(id) ?? '';
  }

  /** Bytes that were sent; 0 while it waits. */
  sentBytesOf(id: string): number {
    return this.#current?.id === id ? this.#current.bytes : 0;
  }

  get isSending(): boolean {
    return this.#current !== undefined;
  }

  /** Uploads a recording when those before are done. */
  add(id: string): void {
    if (this.#waiting.has(id) || this.#current?.id === id) return;
    this.#waiting.add(id);
    this.#problems.delete(id);
    this.#done = this.#done.then(() => this.#upload(id));
  }

  /** It was deleted. */
  forget(id: string): void {
    this.#waiting.delete(id);
    this.#problems.delete(id);
  }

  /** Ends what is being sent. */
  close(): Promise<void> {
    this.#waiting.clear();
    this.#abort.abort();
    return this.#done;
  }

  async #upload(id: string): Promise<void> {
    if (!this.#waiting.delete(id)) return;
    const current = { id, bytes: 0 };
    this.#current = current;
    this.#context.onChange();
    try {
      await this.#context.send(id, this.#abort.signal, (bytes) => (current.bytes = bytes));
      await this.#context.handleSent(id);
    } catch (cause) {
      // Its answer was lost, not the file.
      if (cause instanceof ServiceError && cause.code === 'already_exists') {
        await this.#context.handleSent(id);
      } else this.#problems.set(id, `It is not uploaded: ${messageOf(cause)}`);
    } finally {
      this.#current = undefined;
      this.#context.onChange();
    }
  }
}

function messageOf(cause: unknown): string {
  const text = cause instanceof Error ? cause.message : String(cause);
  return text.endsWith('.') ? text : `${text}.`;
}
