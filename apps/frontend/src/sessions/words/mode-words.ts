import type { ProcessingMode } from '@ubii/proto';

/** Default frequency, also for a frequency of 0, Hz. [PM-20] */
const DEFAULT_HZ = 30;

/** Formats a processing mode: `60 Hz`, `on any input, 16 ms apart`, `lockstep`. */
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
