import type { Init, ProcessingModule } from '@ubii/proto';

/** Frequency of the ticker module, Hz. */
export const TICKER_HERTZ = 60;

/** Sines it adds up in each run: some microseconds of work. */
const SINES = 50;

/**
 * A module that says which run it is, when the run began on the clock of the first one, and the result
 * of a little work.
 */
export const TICKER_MODULE = {
  name: 'benchmark-ticker',
  onProcessingStringified: `(deltaTime, inputs, state) => {
    state.run = state.run === undefined ? 0 : state.run + 1;
    state.elapsed = (state.elapsed || 0) + deltaTime;
    let sum = 0;
    for (let i = 0; i < ${SINES}; i += 1) sum += Math.sin(state.elapsed + i);
    return { outputs: { out: { vector3: { x: state.run, y: state.elapsed, z: sum } } } };
  }`,
  outputs: [{ internalName: 'out', messageFormat: 'vector3' }],
  processingMode: { frequency: { hertz: TICKER_HERTZ } },
} satisfies Init<ProcessingModule>;

/** Room for the last digit of a sine: engines differ in it. */
const TOLERANCE = 1e-9;

/** True when `sum` is what the module makes of `elapsedMs`. */
export function isTickerSum(elapsedMs: number, sum: number): boolean {
  let expected = 0;
  for (let i = 0; i < SINES; i += 1) expected += Math.sin(elapsedMs + i);
  return Math.abs(sum - expected) < TOLERANCE;
}
