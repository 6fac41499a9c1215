import type { Unsubscribe } from './unsubscribe.ts';

/**
 * Callbacks for one kind of fact. One that throws does not keep the others from being called: its
 * exception surfaces as an unhandled rejection, because it is a fault of the program, not of the link.
 */
export class Listeners<T> {
  // Replaced, never changed, so that a callback may add and remove while others are being called.
  #callbacks: readonly ((fact: T) => void)[] = [];

  add(callback: (fact: T) => void): Unsubscribe {
    // Wrapped, so that the same function added twice is called twice and taken back once.
    const added = (fact: T): void => callback(fact);
    this.#callbacks = [...this.#callbacks, added];
    return () => {
      this.#callbacks = this.#callbacks.filter((other) => other !== added);
    };
  }

  emit(fact: T): void {
    for (const callback of this.#callbacks) {
      try {
        callback(fact);
      } catch (error) {
        void Promise.reject(error);
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
