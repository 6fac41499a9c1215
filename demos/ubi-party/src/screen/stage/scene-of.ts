import type { RoundState } from '../../modules/index.ts';
import type { RoundView } from '../../net/index.ts';
import { GAMES, type Game, type GameId, type Room, type Seat } from '../../sim/index.ts';
import type { Scene } from '../../view/stage.ts';

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
