import { placesByScore, STEPS_PER_SECOND, type Game, type Places } from '../game.ts';
import { hillHud } from './hill-hud.ts';
import { hillFeedback } from './hill-feedback.ts';
import { hillBot } from './hill-bot.ts';
import { standing, startHill, type HillState } from './hill-state.ts';
import { LONGEST } from './rings.ts';
import { stepHill, type HillSettings } from './step-hill.ts';

/** Bonus for the last one standing, in steps with the crown. */
const LAST_STANDING = 20 * STEPS_PER_SECOND;

/** King of the Hill: a slippery platform that loses its rings. The time with the crown is the score. */
export const hillGame: Game<HillState, HillSettings> = {
  id: 'hill',
  title: 'King of the Hill',
  explanation: [
    'Stand in the yellow middle to get the crown. Your time with it is your score.',
    'Hold the button to charge, let it go to dash. Push the others off.',
    'The rings fall from the outside in. The last player standing gets 20 seconds.',
  ],
  controller: { steering: 'stick', button: 'Dash', isHeld: true },
  settings: { friction: 1, speed: 1, push: 1 },
  start: startHill,
  step: stepHill,
  isOver: (state) => state.step >= LONGEST || standing(state).length <= 1,
  places,
  feedback: (state, seat) => hillFeedback(state, seat, places(state)),
  hud: hillHud,
  bot: hillBot,
};

function places(state: HillState): Places {
  return placesByScore(
    state.pieces.map(({ seat }) => seat),
    // Of equal scores, who stood longer is before the other
    (seat) => scoreOf(state, seat) * (LONGEST + 2) + stoodFor(state, seat),
  );
}

/** Steps on the platform; who stands has more than everybody who fell. */
function stoodFor(state: HillState, seat: number): number {
  return state.pieces.find((one) => one.seat === seat)!.outAt ?? LONGEST + 1;
}

/** Steps with the crown, with what the last one who stands gets. */
function scoreOf(state: HillState, seat: number): number {
  const left = standing(state);
  const isLast = left.length === 1 && left[0]!.seat === seat;
  const piece = state.pieces.find((one) => one.seat === seat)!;
  return piece.crownSteps + (isLast ? LAST_STANDING : 0);
}
