/** A key by its place, and what it wrote when it went down: with Shift let go first that is another letter. */
export class HeldKeys {
  readonly #keys = new Map<string, string>();

  /** Places of the keys that are down. */
  get codes(): Iterable<string> {
    return this.#keys.keys();
  }

  get names(): readonly string[] {
    return [...this.#keys.values()];
  }

  /** @returns false when it was down already, as when the keyboard repeats it */
  press(code: string, key: string): boolean {
    if (this.#keys.has(code)) return false;
    this.#keys.set(code, key);
    return true;
  }

  /** @returns what it wrote when it went down; nothing when it was not down */
  release(code: string): string | undefined {
    const key = this.#keys.get(code);
    this.#keys.delete(code);
    return key;
  }

  /** Lets go of all; @returns what they wrote */
  releaseAll(): readonly string[] {
    const { names } = this;
    this.#keys.clear();
    return names;
  }
}

/** Keys that leave the pad, and combinations that are the browser's and the system's. */
export function isCaptured(event: {
  readonly key: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly altKey: boolean;
}): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) {
    return ['Control', 'Meta', 'Alt'].includes(event.key);
  }
  return event.key !== 'Tab' && event.key !== 'Escape' && !/^F\d+$/.test(event.key);
}
