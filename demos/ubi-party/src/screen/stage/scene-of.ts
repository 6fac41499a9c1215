import type { RoundState } from '../../modules/index.ts';
import type { RoundView } from '../../net/index.ts';
import { GAMES, type Room, type Seat, type Game, type GameId } from '../../sim/index.ts';
import type { Scene } from '../../view/stage.ts';

/** With more players, bots leave the room for names to people. */
const MAX_NAMED = 18;

/** The names beside the pieces: while people gather, and look for theirs. */
export function namesOf({ phase, players }: Room): ReadonlyMap<Seat, string> {
  if (phase !== 'lobby' && phase !== 'explanation') return new Map();
  const named =
    players.length > MAX_NAMED ? players.filter(({ key }) => key !== undefined) : players;
  return new Map(named.map(({ seat, name }) => [seat, name]));
}

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

/** The scene for the state of a room. @param state of the round that is played, or of its replay */
export function sceneOf(
  room: Room,
  round: RoundView | undefined,
  state: RoundState | undefined,
): Scene {
  const { phase, players, results } = room;
  // Photos hang on a line of their own, above the stage
  const isDrawn = round?.game !== 'hunt';
  if (isDrawn && (phase === 'play' || phase === 'countdown' || (phase === 'podium' && state))) {
    const shown = state?.id === round?.id ? state?.state : undefined;
    if (round) return gameScene(round.game as GameId, shown ?? startOf(round));
  }
  if (phase === 'podium') {
    return { kind: 'podium', players, first: firstThree(results.at(-1)?.places ?? []) };
  }
  if (phase === 'end') {
    const order = [...players].sort((a, b) => b.points - a.points || a.seat - b.seat);
    return { kind: 'podium', players, first: order.slice(0, 3).map(({ seat }) => seat) };
  }
  return { kind: 'lobby', players, words: phase === 'explanation' ? 'explanation' : 'join' };
}

const firstThree = (places: readonly (readonly Seat[])[]): Seat[] => places.flat().slice(0, 3);

function gameScene(game: GameId, state: unknown): Scene {
  const pieces = (GAMES[game] as Game<unknown>).pieces?.(state);
  return pieces
    ? { kind: 'pieces', pieces, hasSides: game === 'quiz' }
    : ({ kind: game, state } as Scene);
}

/** The initial state of a round: the rules compute the same one on every machine. */
function startOf({ game, seed, seats }: RoundView): unknown {
  return (GAMES[game as GameId] as Game<unknown>).start({ seed, seats });
}
