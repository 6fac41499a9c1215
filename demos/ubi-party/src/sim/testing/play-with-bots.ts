import type { Controls, Game, GameSettings, Seat } from '../game.ts';

const MAX_STEPS = 300 * 60;

/** Plays a round of bots to its end. @returns the last state */
export function playWithBots<State, Settings extends GameSettings>(
  game: Game<State, Settings>,
  players: number,
  seed: number,
  onStep: (state: State) => void = () => {},
): State {
  const seats = Array.from({ length: players }, (_, seat) => seat);
  const state = game.start({ seats, seed });
  for (let step = 0; !game.isOver(state); step += 1) {
    if (step > MAX_STEPS) throw new Error(`${game.title} does not end.`);
    const controls = new Map<Seat, Controls>(seats.map((seat) => [seat, game.bot(state, seat)]));
    game.step(state, (seat) => controls.get(seat)!, game.settings);
    onStep(state);
  }
  return state;
}
