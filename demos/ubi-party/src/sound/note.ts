import type { Seat } from '../sim/index.ts';

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

/** Semitones above the root: any two of them sound well together. */
const PENTATONIC = [0, 2, 4, 7, 9] as const;
const MIDDLE_C = 60;
const OCTAVES = 3;

/** The pitch of a player, MIDI number: from middle C upwards, over three octaves. */
export function pitchOf(seat: Seat): number {
  return scalePitch(MIDDLE_C, seat % (PENTATONIC.length * OCTAVES));
}

/** So many steps of the scale above a root, also below it. @returns MIDI number */
export function scalePitch(root: number, degree: number): number {
  const size = PENTATONIC.length;
  const octave = Math.floor(degree / size);
  return root + 12 * octave + PENTATONIC[degree - octave * size]!;
}

/** Equal temperament, A4 (69) is 440 Hz. */
export function hzOf(midi: number): number {
  return 440 * 2 ** ((midi - 69) / 12);
}
