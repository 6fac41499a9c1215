/**
 * Pressed keys by `code`, with the `key` at the time of the press: it differs at the release if Shift is released
 * first.
 */
export class HeldKeys {
  readonly #keys = new Map<string, string>();

  /** Codes of the pressed keys. */
  get codes(): Iterable<string> {
    return this.#keys.keys();
  }

  get names(): readonly string[] {
    return [...this.#keys.values()];
  }

  /** @returns false when it was pressed already, as for key repeat */
  press(code: string, key: string): boolean {
    if (this.#keys.has(code)) return false;
    this.#keys.set(code, key);
    return true;
  }

  /** @returns its `key` at the press; undefined when it was not pressed */
  release(code: string): string | undefined {
    const key = this.#keys.get(code);
    this.#keys.delete(code);
    return key;
  }

  /** Releases all keys; @returns their `key`s */
  releaseAll(): readonly string[] {
    const { names } = this;
    this.#keys.clear();
    return names;
  }
}

/** False for keys that leave the pad, and for shortcuts of browser and operating system. */
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
