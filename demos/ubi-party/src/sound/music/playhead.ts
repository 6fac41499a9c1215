import type { Note } from '../note.ts';
import { notesBetween, type Tune } from './tune.ts';

/** Says which notes of a tune come when, a window of time after the other. */
export class Playhead {
  #tune: Tune | undefined;
  /** A moment whose beat is known. */
  #anchorS = 0;
  #anchorBeat = 0;
  /** Notes before it were given. */
  #takenS = 0;

  /** A tune of the same id goes on at its beat, with its new tempo; another one begins now; none is silence. */
  play(tune: Tune | undefined, nowS: number): void {
    const goesOn = tune !== undefined && tune.id === this.#tune?.id;
    if (goesOn) {
      const fromS = Math.max(this.#takenS, nowS);
      [this.#anchorBeat, this.#anchorS] = [this.#beatAt(fromS), fromS];
    } else [this.#anchorBeat, this.#anchorS, this.#takenS] = [0, nowS, nowS];
    this.#tune = tune;
  }

  /** The notes that were not given yet. What lies before now is left out: it is too late. */
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
