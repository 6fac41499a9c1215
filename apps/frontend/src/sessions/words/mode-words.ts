import type { ProcessingMode } from '@ubii/proto';

/** A mode without one, and what a frequency of 0 means. [PM-20] */
const DEFAULT_HZ = 30;

/** When a module runs, in a few words: `60 Hz`, `on any input, 16 ms apart`, `lockstep`. */
export function modeWords(mode: ProcessingMode | undefined): string {
  if (mode?.triggerOnInput) {
    const { allInputsNeedUpdate, minDelayMs } = mode.triggerOnInput;
    const apart = minDelayMs > 0 ? `, ${minDelayMs} ms apart` : '';
    return `on ${allInputsNeedUpdate ? 'all inputs' : 'any input'}${apart}`;
  }
  if (mode?.lockstep) return 'lockstep';
  if (mode?.free) return 'free';
  const hertz = mode?.frequency?.hertz ?? 0;
  return `${hertz > 0 ? hertz : DEFAULT_HZ} Hz`;
}
