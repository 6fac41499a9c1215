import type { Note } from '../note.ts';

/** Music that repeats. Tunes of the same id go on from each other's beat. */
export interface Tune {
  readonly id: string;
  readonly bpm: number;
  /** After so many beats it begins again. */
  readonly beats: number;
  readonly notes: readonly TuneNote[];
}
export interface TuneNote extends Note {
  /** Beats since the beginning of the tune. */
  readonly at: number;
}

/** The notes of a window of beats, `from` included and `to` not, in their order. */
export function notesBetween(
  { notes, beats }: Tune,
  from: number,
  to: number,
): { readonly beat: number; readonly note: TuneNote }[] {
  const found: { beat: number; note: TuneNote }[] = [];
  for (let loop = Math.floor(from / beats); loop * beats < to; loop += 1) {
    for (const note of notes) {
      const beat = loop * beats + note.at;
      if (beat >= from && beat < to) found.push({ beat, note });
    }
  }
  return found.sort((a, b) => a.beat - b.beat);
}
