/**
 * Returns a generator of numbers from 0 to below 1, the same numbers for the same seed in every version of the master.
 *
 * Sources: FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv; mulberry32 by Tommy Ettinger, public domain.
 */
export function createRandom(seed: string): () => number {
  let state = 0x811c9dc5;
  for (let index = 0; index < seed.length; index++) {
    state = Math.imul(state ^ seed.charCodeAt(index), 0x01000193);
  }
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}
