import { withPace, type Game } from '../game.ts';
import { randomState } from '../random.ts';
import { huntBot } from './hunt-bot.ts';
import { huntFeedback } from './hunt-feedback.ts';
import { huntHud } from './hunt-hud.ts';
import { placesOf } from './hunt-points.ts';
import { FIRST_SETTINGS, type HuntSettings, type HuntState } from './hunt-state.ts';
import { stepHunt } from './step-hunt.ts';
import { THINGS } from './things.ts';

/** Find a real thing and take a photo of it. Phones look at their photos themselves. */
export const huntGame: Game<HuntState, HuntSettings> = {
  id: 'hunt',
  title: 'Photo Hunt',
  explanation: [
    'Find the thing on the screen and take a photo of it. Five things.',
    'The first gets 3 points, the second 2, others 1, and the best photo 1 more.',
    'Your phone checks the photo. Nobody sees it unless you show it.',
  ],
  // Phones load the detector meanwhile, megabytes over the Wi-Fi of the room.
  explanationMs: 60_000,
  controller: { steering: 'camera', button: 'Take a photo', isHeld: false },
  settings: FIRST_SETTINGS,
  switches: Object.fromEntries(Object.entries(THINGS).map(([id, { name }]) => [id, name])),
  start: (setup) => ({
    random: randomState(setup.seed),
    ...withPace(setup),
    step: 0,
    seats: setup.seats,
    hunted: [],
    points: Object.fromEntries(setup.seats.map((seat) => [seat, 0])),
    wrongAt: {},
    isOver: false,
  }),
  step: stepHunt,
  isOver: ({ isOver }) => isOver,
  places: placesOf,
  feedback: huntFeedback,
  hud: huntHud,
  bot: huntBot,
};
