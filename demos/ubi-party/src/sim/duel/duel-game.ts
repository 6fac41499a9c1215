import { counted } from '@ubii/words';

import {
  placeOf,
  STEPS_PER_SECOND,
  AT_REST,
  placesByScore,
  WAIT_FOR_LATE_MS,
  withPace,
  NEWS_STEPS,
  type Feedback,
  type WithPace,
  type Seat,
  type Game,
  type Places,
  type GameSettings,
  type Hud,
} from '../game.ts';
import { drawInteger, randomState, type WithRandom } from '../random.ts';

/** One signal, and who pressed when. */
interface Bout {
  /** Milliseconds since the start of the round; a press before belongs to the bout before. */
  readonly beganAtMs: number;
  /** On the same clock. */
  readonly signalAtMs: number;
  /** When each pressed first in this bout. */
  readonly presses: Record<Seat, number>;
}

export interface DuelState extends WithRandom, WithPace {
  /** Steps since the start. */
  step: number;
  readonly seats: readonly Seat[];
  bout: Bout;
  /** Bouts that are decided, with the winner (undefined: none) and the reaction time, milliseconds. */
  readonly decided: { readonly winner?: Seat; readonly reactionMs?: number }[];
}

function duelHud(state: DuelState, headline: string, nameOf: (seat: Seat) => string): Hud {
  const { seats, decided, bout, step } = state;
  const winsOf = (seat: Seat): number => decided.filter(({ winner }) => winner === seat).length;
  const notes = Object.fromEntries(seats.map((seat) => [seat, counted(winsOf(seat), 'win')]));
  const last = decided.at(-1);
  const sinceSteps = step - (bout.beganAtMs / 1000) * STEPS_PER_SECOND;
  const isNew = last?.winner !== undefined && sinceSteps < NEWS_STEPS;
  return {
    headline,
    notes,
    out: [],
    ...(isNew && {
      news: {
        seat: last.winner!,
        sentence: `${nameOf(last.winner!)} draws after ${Math.round(last.reactionMs ?? 0)} ms`,
      },
    }),
  };
}

export interface DuelSettings extends GameSettings {
  /** Factor of the wait for the signal: 1 is 1.5 to 5 seconds. */
  readonly patience: number;
}

const BOUTS = 5;
const MAX_EXTRA = 3;
/** Faster is guessed, not seen (World Athletics, technical rules: 100 ms). */
export const MIN_REACTION_MS = 100;
const LONGEST_REACTION_MS = 1500;

/** Reaction duel: press when the screen turns. What counts is when the button went down. */
export const duelGame: Game<DuelState, DuelSettings> = {
  id: 'duel',
  title: 'Quick Draw',
  explanation: [
    'Wait until the flag falls, then press. Five times.',
    'If you press too early, you are out until the next flag.',
    'Slow Wi-Fi does not matter: the time of your press counts.',
  ],
  controller: { steering: 'none', button: 'Draw', isHeld: false },
  settings: { patience: 1 },
  start(setup) {
    const { seats, seed } = setup;
    const random = { random: randomState(seed) };
    return {
      ...random,
      ...withPace(setup),
      step: 0,
      seats,
      bout: nextBout(random, 0, 1),
      decided: [],
    };
  },
  step(state, controls, { patience }) {
    state.step += 1;
    const nowMs = (state.step * 1000) / STEPS_PER_SECOND;
    const { presses, beganAtMs, signalAtMs } = state.bout;
    for (const seat of state.seats) {
      const { pressedAtMs } = controls(seat);
      if (pressedAtMs === undefined || seat in presses || pressedAtMs <= beganAtMs) continue;
      // Steps that catch up are behind what arrived: the press belongs to a later one
      if (pressedAtMs <= nowMs) presses[seat] = pressedAtMs;
    }
    const endsAtMs = signalAtMs + longestReactionMs(state) + WAIT_FOR_LATE_MS;
    if (nowMs < endsAtMs && !isDecidable(state, nowMs)) return;
    state.decided.push(decide(state));
    state.bout = nextBout(state, nowMs, patience);
  },
  isOver,
  places,
  feedback,
  hud: (state, nameOf) => duelHud(state, headlineOf(state), nameOf),
  bot(state, seat) {
    const nowMs = (state.step * 1000) / STEPS_PER_SECOND;
    const pressedAtMs =
      state.bout.signalAtMs + 260 + ((seat * 37 + state.decided.length * 53) % 160);
    return nowMs < pressedAtMs ? AT_REST : { x: 0, y: 0, isPressed: true, pressedAtMs };
  },
};

/** Sudden death: while several lead, one more flag, three times at most. */
function isOver(state: DuelState): boolean {
  const { length } = state.decided;
  return length >= BOUTS + MAX_EXTRA || (length >= BOUTS && places(state)[0]!.length === 1);
}

function places({ seats, decided }: DuelState): Places {
  return placesByScore(seats, (seat) => winsOf(decided, seat));
}

function winsOf(decided: DuelState['decided'], seat: Seat): number {
  return decided.filter(({ winner }) => winner === seat).length;
}

function headlineOf({ decided }: DuelState): string {
  return decided.length < BOUTS ? `Flag ${decided.length + 1} of ${BOUTS}` : 'Sudden death';
}

function feedback(state: DuelState, seat: Seat): Feedback {
  const { seats, decided, bout } = state;
  const pressedAtMs = bout.presses[seat];
  const isEarly = pressedAtMs !== undefined && pressedAtMs < bout.signalAtMs + MIN_REACTION_MS;
  const last = decided.at(-1);
  const sentence =
    pressedAtMs === undefined
      ? last?.winner === seat
        ? `You won with ${Math.round(last.reactionMs ?? 0)} ms. Wait for the next flag.`
        : 'Wait until the flag falls, then press.'
      : isEarly
        ? 'Too early. You are back in the next bout.'
        : `You pressed after ${Math.round(pressedAtMs - bout.signalAtMs)} ms.`;
  return {
    place: placeOf(places(state), seat),
    of: seats.length,
    headline: headlineOf(state),
    sentence,
    progress: Math.min(1, decided.length / BOUTS),
    gauge: pressedAtMs === undefined ? 1 : 0,
    isReady: pressedAtMs === undefined,
    isOut: false,
    hitAt: isEarly ? state.step : 0,
  };
}

/** Whether the flag has fallen, for who draws it. */
export function isSignalled({ bout, step }: DuelState): boolean {
  return (step * 1000) / STEPS_PER_SECOND >= bout.signalAtMs;
}

function nextBout(state: WithRandom, nowMs: number, patience: number): Bout {
  const signalAtMs = nowMs + 1500 + drawInteger(state, 0, 3500) * patience;
  return { beganAtMs: nowMs, signalAtMs, presses: {} };
}

/** All players have pressed, and no earlier press can be on its way. */
function isDecidable({ seats, bout: { presses } }: DuelState, nowMs: number): boolean {
  return (
    seats.every((seat) => seat in presses) &&
    nowMs >= Math.max(...Object.values(presses)) + WAIT_FOR_LATE_MS
  );
}

const longestReactionMs = ({ pace = 1 }: WithPace): number => LONGEST_REACTION_MS * pace;

function decide(state: DuelState): DuelState['decided'][number] {
  const {
    seats,
    bout: { presses, signalAtMs },
  } = state;
  const [best] = seats
    .flatMap((seat) =>
      seat in presses ? { winner: seat, reactionMs: presses[seat]! - signalAtMs } : [],
    )
    .filter(
      ({ reactionMs }) => reactionMs >= MIN_REACTION_MS && reactionMs <= longestReactionMs(state),
    )
    .sort((a, b) => a.reactionMs - b.reactionMs);
  return best ?? {};
}
