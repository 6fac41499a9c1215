import {
  AT_REST,
  STEPS_PER_SECOND,
  type Controls,
  type Game,
  type GameSettings,
  type Seat,
} from '../game.ts';

/** Steps between two stored states. */
const STEPS_PER_SNAPSHOT = STEPS_PER_SECOND;
const SNAPSHOTS_KEPT = 15;

interface Snapshot {
  /** The state as JSON before the steps. */
  readonly state: string;
  readonly steps: {
    readonly controls: ReadonlyMap<Seat, Controls>;
    readonly settings: GameSettings;
  }[];
}

/**
 * Plays a round and remembers its last 15 seconds: a state each second and what the controllers said in between, from
 * which any moment is played again exactly.
 */
export class PlayedRound<State, Settings extends GameSettings> {
  readonly #game: Game<State, Settings>;
  readonly #snapshots: Snapshot[] = [];
  /** Changed by each step. */
  readonly state: State;

  constructor(game: Game<State, Settings>, state: State) {
    this.#game = game;
    this.state = state;
  }

  /** @param controls of each seat of the round; who is missing is at rest */
  step(controls: ReadonlyMap<Seat, Controls>, settings: Settings): void {
    const last = this.#snapshots.at(-1);
    if (!last || last.steps.length === STEPS_PER_SNAPSHOT) {
      this.#snapshots.push({ state: JSON.stringify(this.state), steps: [] });
      if (this.#snapshots.length > SNAPSHOTS_KEPT) this.#snapshots.shift();
    }
    this.#snapshots.at(-1)!.steps.push({ controls, settings });
    stepWith(this.#game, this.state, controls, settings);
  }

  /**
   * The states of the last seconds, one a step, the oldest first. Each is the same object, changed: draw it before the
   * next is taken.
   *
   * @param seconds as far as they are remembered
   */
  *replay(seconds: number): Generator<State> {
    const wanted = Math.round(seconds * STEPS_PER_SECOND);
    const known = this.#snapshots.reduce((sum, { steps }) => sum + steps.length, 0);
    let toSkip = Math.max(0, known - wanted);
    let from = 0;
    while (from < this.#snapshots.length && toSkip >= this.#snapshots[from]!.steps.length) {
      toSkip -= this.#snapshots[from]!.steps.length;
      from += 1;
    }
    const first = this.#snapshots[from];
    if (!first) return;
    const state = JSON.parse(first.state) as State;
    for (const { controls, settings } of this.#snapshots
      .slice(from)
      .flatMap(({ steps }) => steps)) {
      stepWith(this.#game, state, controls, settings as Settings);
      if (toSkip > 0) toSkip -= 1;
      else yield state;
    }
  }
}

function stepWith<State, Settings extends GameSettings>(
  game: Game<State, Settings>,
  state: State,
  controls: ReadonlyMap<Seat, Controls>,
  settings: Settings,
): void {
  game.step(state, (seat) => controls.get(seat) ?? AT_REST, settings);
}
