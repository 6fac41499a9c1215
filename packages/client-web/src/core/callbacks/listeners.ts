import { reportRejection } from './program-errors.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import type { Unsubscribe } from './unsubscribe.ts';

/**
 * Callbacks for one kind of fact. One that throws, or whose promise rejects, does not keep the others
 * from being called: its error goes to `onError`.
 */
export class Listeners<T> {
  // Replaced, never changed, so that a callback may add and remove while others are being called.
  #callbacks: readonly ((fact: T) => void)[] = [];
  readonly #onError: ErrorHandler;

  constructor(onError: ErrorHandler) {
    this.#onError = onError;
  }

  add(callback: (fact: T) => void): Unsubscribe {
    // Wrapped, so that the same function added twice is called twice and taken back once.
    const added = (fact: T) => callback(fact);
    this.#callbacks = [...this.#callbacks, added];
    return () => {
      this.#callbacks = this.#callbacks.filter((other) => other !== added);
    };
  }

  emit(fact: T): void {
    for (const callback of this.#callbacks) {
      try {
        reportRejection(callback(fact), 'listener', this.#onError);
      } catch (error) {
        this.#onError(error, 'listener');
      }
    }
  }

  clear(): void {
    this.#callbacks = [];
  }

  get size(): number {
    return this.#callbacks.length;
  }
}
