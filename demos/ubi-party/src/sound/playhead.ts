import type { Note } from './note.ts';

/** Music that repeats. A tune continues at the beat of the one before it if both have the same id. */
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

/** Schedules the notes of a tune, one window of time after the other. */
export class Playhead {
  #tune: Tune | undefined;
  /** A time whose beat is known. */
  #anchorS = 0;
  #anchorBeat = 0;
  /** Notes before it were returned. */
  #takenS = 0;

  /** Continues a tune of the same id at its beat, with the new tempo; starts another one now; undefined is silence. */
  play(tune: Tune | undefined, nowS: number): void {
    const isContinued = tune !== undefined && tune.id === this.#tune?.id;
    if (isContinued) {
      const fromS = Math.max(this.#takenS, nowS);
      [this.#anchorBeat, this.#anchorS] = [this.#beatAt(fromS), fromS];
    } else [this.#anchorBeat, this.#anchorS, this.#takenS] = [0, nowS, nowS];
    this.#tune = tune;
  }

  /** Returns the notes that were not returned yet. Notes before now are dropped. */
  take(nowS: number, untilS: number): { readonly atS: number; readonly note: Note }[] {
    const tune = this.#tune;
    const fromS = Math.max(this.#takenS, nowS);
    if (!tune || untilS <= fromS) return [];
    this.#takenS = untilS;
    return notesBetween(tune, this.#beatAt(fromS), this.#beatAt(untilS)).map(({ beat, note }) => ({
      atS: this.#anchorS + ((beat - this.#anchorBeat) * 60) / tune.bpm,
      note,
    }));
  }

  #beatAt(timeS: number): number {
    return this.#anchorBeat + ((timeS - this.#anchorS) * (this.#tune?.bpm ?? 0)) / 60;
  }
}
