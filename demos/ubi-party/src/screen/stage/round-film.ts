import type { RoundState } from '../../modules/index.ts';

/** As far as the newest states are kept, steps of 1/60 s. */
const KEPT_STEPS = 4 * 60;
/** The decisive moment is the end of the round, at this share of the speed. */
const SPEED = 0.6;

/** The newest states of a round, to be drawn as they come and once more when it is over. */
export class RoundFilm {
  #frames: RoundState[] = [];

  /** A state of another round begins again. */
  add(state: RoundState): void {
    const last = this.#frames.at(-1);
    if (last && (last.id !== state.id || last.step >= state.step)) this.#frames = [];
    this.#frames.push(state);
    while (this.#frames.length > 1 && this.#frames[0]!.step < state.step - KEPT_STEPS)
      this.#frames.shift();
  }

  get newest(): RoundState | undefined {
    return this.#frames.at(-1);
  }

  /** Duration of the replay, milliseconds; 0 when nothing was recorded. */
  get lengthMs(): number {
    const [first] = this.#frames;
    const last = this.newest;
    return first && last ? ((last.step - first.step) * 1000) / 60 / SPEED : 0;
  }

  /** The state of a moment of the replay. @param atMs since its start; undefined when it is over */
  at(atMs: number): RoundState | undefined {
    if (atMs > this.lengthMs) return undefined;
    const step = (this.#frames[0]?.step ?? 0) + ((atMs * SPEED) / 1000) * 60;
    return this.#frames.find((frame) => frame.step >= step);
  }
}
