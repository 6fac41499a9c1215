import { uniformInt } from 'pure-rand/distribution/uniformInt';
import { xoroshiro128plus, xoroshiro128plusFromState } from 'pure-rand/generator/xoroshiro128plus';

/** The state of a random generator as it is kept in the state of a game. */
export type RandomState = readonly number[];

/** A state that holds a generator; drawing renews it. */
export interface WithRandom {
  random: RandomState;
}

/** @param seed any 32-bit integer */
export function randomState(seed: number): RandomState {
  return [...xoroshiro128plus(seed).getState()];
}

/** A uniform integer from `from` to `to`, both included. */
export function drawInteger(state: WithRandom, from: number, to: number): number {
  const generator = xoroshiro128plusFromState(state.random);
  const drawn = uniformInt(generator, from, to);
  state.random = [...generator.getState()];
  return drawn;
}

/** A uniform number from 0 to 1 in steps of 1/65536. */
export function drawFraction(state: WithRandom): number {
  return drawInteger(state, 0, 65536) / 65536;
}
