import type { ProcessingMode } from '@ubii/proto';

export type ModeKind = 'frequency' | 'trigger' | 'lockstep' | 'free';

/** A module without a mode runs at a frequency. [PM-20] */
export function modeKind(mode: ProcessingMode | undefined): ModeKind {
  if (mode?.triggerOnInput) return 'trigger';
  if (mode?.lockstep) return 'lockstep';
  if (mode?.free) return 'free';
  return 'frequency';
}

/** Returns the default mode of a kind. */
export function modeOf(kind: ModeKind): ProcessingMode {
  switch (kind) {
    case 'frequency':
      return { frequency: { hertz: 30 } };
    case 'trigger':
      return { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } };
    case 'lockstep':
      return { lockstep: { processRequestEndpoint: '' } };
    case 'free':
      return { free: {} };
  }
}
