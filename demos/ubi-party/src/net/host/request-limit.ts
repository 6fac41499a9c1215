const MAX_PHONES = 128;

/** Rate limit of a phone: burst size and requests per second. */
export interface Rate {
  readonly atOnce: number;
  readonly perSecond: number;
}

/** Holds back who asks too often; the others are not affected. */
export class RequestLimit {
  readonly #left = new Map<string, { left: number; atMs: number }>();
  readonly #rate: Rate;

  constructor(rate: Rate = { atOnce: 10, perSecond: 5 }) {
    this.#rate = rate;
  }

  isAllowed(key: string, nowMs: number): boolean {
    const { atOnce, perSecond } = this.#rate;
    const known = this.#left.get(key);
    if (!known && this.#left.size >= MAX_PHONES) this.#left.clear();
    const left = known
      ? Math.min(atOnce, known.left + ((nowMs - known.atMs) / 1000) * perSecond)
      : atOnce;
    this.#left.set(key, { left: left < 1 ? left : left - 1, atMs: nowMs });
    return left >= 1;
  }
}
