import { counted } from '@ubii/words';

import { placeOf, placesByScore, STEP_S, STEPS_PER_SECOND, type Game, type Seat } from '../game.ts';
import { clamp, length, unit, withinOne, type Vector } from '../plane/plane.ts';
import { drawInteger, randomState, type WithRandom } from '../random.ts';

interface Runner {
  readonly seat: Seat;
  readonly position: Vector;
  found: number;
  /** Remaining stamina, 0 to 1. */
  breath: number;
}

/** Plain data: numbers, texts, arrays and objects. */
export interface TemplateState extends WithRandom {
  /** Steps since the start. */
  step: number;
  readonly runners: Runner[];
  /** Position of the hidden apple; a runner who touches it has found it. */
  readonly apple: Vector;
  /** The newest find. */
  last?: { readonly seat: Seat; readonly at: number };
}

const ROUND_STEPS = 45 * STEPS_PER_SECOND;
/** Units; the table reaches from -10 to 10. */
const EDGE = 9;
const REACH = 1.5;
/** Units per second. */
const SPEED = 6;
const RUN = 2;

/** Apple Hunt: the screen says roughly where an apple is hidden. Who finds most in 45 seconds wins. */
export const templateGame: Game<TemplateState, { readonly speed: number }> = {
  id: 'template',
  title: 'Apple Hunt',
  explanation: [
    'An apple is hidden. The screen says where. Find it first.',
    'Hold the button to run.',
  ],
  controller: { steering: 'stick', button: 'Run', isHeld: true },
  settings: { speed: 1 },

  start({ seats, seed }) {
    const state: TemplateState = {
      random: randomState(seed),
      step: 0,
      runners: seats.map((seat, index) => ({
        seat,
        position: { x: (index % 8) * 2 - 7, y: Math.floor(index / 8) * -2 - 2 },
        found: 0,
        breath: 1,
      })),
      apple: { x: 0, y: 0 },
    };
    moveApple(state);
    return state;
  },

  step(state, controls, { speed }) {
    state.step += 1;
    for (const runner of state.runners) {
      const { isPressed, ...stick } = controls(runner.seat);
      const isRunning = isPressed && runner.breath > 0;
      runner.breath = clamp(runner.breath + (isRunning ? -STEP_S : STEP_S / 3), 0, 1);
      const { x, y } = withinOne(stick);
      const way = SPEED * speed * STEP_S * (isRunning ? RUN : 1);
      runner.position.x = clamp(runner.position.x + x * way, -EDGE, EDGE);
      runner.position.y = clamp(runner.position.y + y * way, -EDGE, EDGE);
    }
    const finder = state.runners.find((runner) => length(toApple(state, runner)) < REACH);
    if (!finder) return;
    finder.found += 1;
    state.last = { seat: finder.seat, at: state.step };
    moveApple(state);
  },

  isOver: ({ step }) => step >= ROUND_STEPS,

  places: ({ runners }) =>
    placesByScore(
      runners.map(({ seat }) => seat),
      (seat) => runners.find((runner) => runner.seat === seat)!.found,
    ),

  feedback(state, seat) {
    const runner = state.runners.find((one) => one.seat === seat);
    const found = runner?.found ?? 0;
    return {
      place: placeOf(templateGame.places(state), seat),
      of: state.runners.length,
      headline: counted(found, 'apple'),
      sentence: state.last?.seat === seat ? 'You found it!' : 'Look for the next apple.',
      progress: state.step / ROUND_STEPS,
      gauge: runner?.breath ?? 0,
      isReady: (runner?.breath ?? 0) > 0,
      isOut: false,
      hitAt: state.last?.seat === seat ? state.last.at : 0,
    };
  },

  hud({ step, runners, last, apple }, nameOf) {
    const isNew = last !== undefined && step - last.at < 1.6 * STEPS_PER_SECOND;
    const side = apple.x < 0 ? 'Left' : 'Right';
    return {
      headline: `${side}, ${apple.y < 0 ? 'near' : 'far'}`,
      notes: Object.fromEntries(runners.map(({ seat, found }) => [seat, String(found)])),
      out: [],
      corner: {
        value: String(Math.ceil((ROUND_STEPS - step) / STEPS_PER_SECOND)),
        label: 'seconds left',
      },
      ...(isNew && { news: { seat: last.seat, sentence: `${nameOf(last.seat)} finds it` } }),
    };
  },

  bot(state, seat) {
    const runner = state.runners.find((one) => one.seat === seat)!;
    // Bots are not equally fast
    const share = 0.5 + (seat % 4) * 0.1;
    const { x, y } = unit(toApple(state, runner), { x: 0, y: 0 });
    return { x: x * share, y: y * share, isPressed: false };
  },

  pieces: ({ runners }) =>
    runners.map(({ seat, position }) => ({ seat, ...position, isOut: false })),
};

function toApple({ apple }: TemplateState, { position }: Runner): Vector {
  return { x: apple.x - position.x, y: apple.y - position.y };
}

function moveApple(state: TemplateState): void {
  state.apple.x = drawInteger(state, -8, 8);
  state.apple.y = drawInteger(state, -8, 8);
}
