/** Wishes that a phone may have at once, and then a second. */
const AT_ONCE = 10;
const PER_SECOND = 5;
const MOST_PHONES = 128;

/** Holds back who asks too often; the others are not affected. */
export class RequestLimit {
  readonly #left = new Map<string, { left: number; atMs: number }>();

  isAllowed(key: string, nowMs: number): boolean {
    const known = this.#left.get(key);
    if (!known && this.#left.size >= MOST_PHONES) this.#left.clear();
    const left = known
      ? Math.min(AT_ONCE, known.left + ((nowMs - known.atMs) / 1000) * PER_SECOND)
      : AT_ONCE;
    this.#left.set(key, { left: left < 1 ? left : left - 1, atMs: nowMs });
    return left >= 1;
  }
}
