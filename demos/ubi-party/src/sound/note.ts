/** The struck instruments. */
export const VOICES = [
  'marimba',
  'bass',
  'brush',
  'felt',
  'shaker',
  'clock',
  'block',
  'knock',
  'mallet',
  'marble',
  'drum',
] as const;
export type Voice = (typeof VOICES)[number];

export interface Note {
  readonly voice: Voice;
  /** MIDI number. */
  readonly midi: number;
  /** 0 to 1. */
  readonly strength: number;
}
