/**
 * Deterministic random numbers: the same seed gives the same numbers on every machine.
 * Xorshift with 128 bits of state, source: G. Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8 (2003).
 */
export class Random {
  readonly seed: number;
  readonly #state: Uint32Array;

  /** @param seed unsigned 32-bit integer */
  constructor(seed: number) {
    this.seed = seed >>> 0;
    this.#state = Uint32Array.of(this.seed ^ 0x9e3779b9, 362436069, 521288629, 88675123);
    for (let i = 0; i < 16; i++) this.next();
  }

  /** Returns an unsigned 32-bit integer. */
  next(): number {
    const state = this.#state;
    let t = state[0]! ^ (state[0]! << 11);
    t ^= t >>> 8;
    state[0] = state[1]!;
    state[1] = state[2]!;
    state[2] = state[3]!;
    state[3] = state[3]! ^ (state[3]! >>> 19) ^ t;
    return state[3]!;
  }

  /** Returns an integer from 0 to `below` - 1; 0 when `below` is 0. */
  below(below: number): number {
    return below <= 0 ? 0 : this.next() % below;
  }

  /** Returns true once in `n` calls on average. */
  oneIn(n: number): boolean {
    return this.below(n) === 0;
  }

  pick<T>(list: readonly T[]): T {
    return list[this.below(list.length)]!;
  }

  bytes(length: number): Uint8Array {
    return Uint8Array.from({ length }, () => this.next() & 0xff);
  }
}
