import { placesByScore, type Game, type Places } from '../game.ts';
import { raceHud } from './race-hud.ts';
import { raceFeedback } from './race-feedback.ts';
import { raceBot } from './race-bot.ts';
import { LONGEST_RACE, startRace, stepsAfterFirst, type RaceState } from './race-state.ts';
import { stepRace, type RaceSettings } from './step-race.ts';

/** Marble Dash: three laps; who left the track is put back. */
export const raceGame: Game<RaceState, RaceSettings> = {
  id: 'race',
  title: 'Marble Dash',
  explanation: [
    'Steer by tilting the phone, or with your thumb. The cart drives automatically.',
    'Chevrons boost you. Press when the pad is full for a boost of your own.',
    'If you leave the track, you are put back. When the first player finishes, the others have a time limit.',
  ],
  controller: { steering: 'wheel', button: 'Boost', isHeld: false },
  settings: { speed: 1, grip: 1, gravity: 1 },
  start: startRace,
  step: stepRace,
  isOver,
  places,
  feedback: (state, seat) => raceFeedback(state, seat, places(state)),
  hud: (state, nameOf) => raceHud(state, places(state), nameOf),
  bot: raceBot,
};

function places(state: RaceState): Places {
  return placesByScore(
    state.carts.map(({ seat }) => seat),
    (seat) => scoreOf(state, seat),
  );
}

function isOver(state: RaceState): boolean {
  const { step, carts } = state;
  const finished = carts.flatMap(({ finishedAt }) => finishedAt ?? []);
  if (finished.length === carts.length || step >= LONGEST_RACE) return true;
  return finished.length > 0 && step >= Math.min(...finished) + stepsAfterFirst(state);
}

/** Carts that have finished come first, the earliest at the top; the others by the distance driven. */
function scoreOf({ carts }: RaceState, seat: number): number {
  const { finishedAt, distance } = carts.find((cart) => cart.seat === seat)!;
  return finishedAt === undefined ? distance - 1e6 : -finishedAt;
}
