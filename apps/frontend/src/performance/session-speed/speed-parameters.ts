import type { Init, ProcessingMode } from '@ubii/proto';

/** Processing mode of the modules. */
export type SpeedMode = 'frequency' | 'triggerOnInput' | 'lockstep' | 'free';

export interface SpeedParameters {
  /** Number of additions per run. */
  readonly iterations: number;
  /** Number of modules in the session. */
  readonly instances: number;
  readonly mode: SpeedMode;
  /** Runs per second of each module, with `frequency`. */
  readonly hertz: number;
  readonly seconds: number;
}

export const SPEED_MODE_WORDS: Readonly<Record<SpeedMode, string>> = {
  frequency: 'Frequency',
  triggerOnInput: 'Trigger on input',
  lockstep: 'Lockstep',
  free: 'Free',
};

export function processingMode({ mode, hertz }: SpeedParameters): Init<ProcessingMode> {
  switch (mode) {
    case 'frequency':
      return { frequency: { hertz } };
    case 'triggerOnInput':
      return { triggerOnInput: {} };
    case 'lockstep':
      return { lockstep: {} };
    case 'free':
      return { free: {} };
  }
}
