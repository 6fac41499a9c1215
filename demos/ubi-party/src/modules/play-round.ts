import {
  AT_REST,
  GAMES,
  STEPS_PER_SECOND,
  type Answer,
  type Controls,
  type Game,
  type Seat,
} from '../sim/index.ts';
import {
  isRoundPlan,
  isRoundSeats,
  type RoundPlan,
  type RoundSeats,
  type RoundState,
} from './round.ts';
import { judgeOnce, readAnswer, type JudgedTime, type AnswerRecord } from './phone-input.ts';

/** The inputs of a module that plays a game, as they come from the runtime. */
export interface RoundInputs {
  readonly round?: { readonly string?: string };
  readonly seats?: { readonly string?: string };
  readonly sticks?: List<{ readonly vector2?: { readonly x: number; readonly y: number } }>;
  readonly buttons?: List<{ readonly bool?: boolean }>;
  readonly pressed?: List<{ readonly double?: number }>;
  readonly answers?: List<AnswerRecord>;
  readonly [setting: string]: unknown;
}
interface List<T> {
  readonly elements: readonly (T & {
    readonly identity?: string;
    readonly receivedAtMs?: number;
  })[];
}

/** State of one module instance. */
export interface Playing {
  plan?: RoundPlan;
  /** The text that `plan` was read from. */
  planText?: string;
  seats?: RoundSeats;
  seatsText?: string;
  /** Of the game. */
  state?: unknown;
  step?: number;
  isOver?: boolean;
  /** When each seat pressed last, and answered last. */
  presses?: Record<Seat, JudgedTime>;
  answers?: Record<Seat, JudgedTime>;
  /** The last feedback sent to each client, with the step of its last hit. */
  sent?: Record<string, { readonly text: string; readonly hitAt: number }>;
}

/** The outputs of the module. */
export interface RoundOutputs {
  readonly outputs: {
    readonly state?: { readonly string: string };
    readonly feedback?: {
      readonly elements: readonly {
        readonly string: string;
        readonly outputTopicParams: readonly string[];
      }[];
    };
  };
}

/** A module that was held up catches up so many steps a run. */
const MAX_STEPS_A_RUN = 12;
/** Feedback is sent ten times a second, and at once after a hit. */
const STEPS_BETWEEN_FEEDBACK = 6;
/** Presses that claim to be further from their arrival do not count, milliseconds. */
const OLDEST_PRESS_MS = 2000;
const MAX_SETTING = 5;

/**
 * One run of a module that plays a game: as many steps as are due, with what the phones say now.
 *
 * @param nowMs milliseconds since the Unix epoch, master's clock
 */
export function playRound(
  id: keyof typeof GAMES,
  inputs: RoundInputs,
  playing: Playing,
  nowMs: number,
): RoundOutputs | undefined {
  const game = GAMES[id] as Game<unknown>;
  readPlan(game, inputs.round?.string, playing);
  readSeats(inputs.seats?.string, playing);
  const { plan } = playing;
  if (!plan || playing.isOver === true) return undefined;
  const due = Math.floor(((nowMs - plan.startsAtMs) * STEPS_PER_SECOND) / 1000);
  const steps = Math.min(MAX_STEPS_A_RUN, due - playing.step!);
  if (steps <= 0) return undefined;
  const settings = readSettings(game, inputs);
  const controls = readControls(inputs, playing, nowMs);
  for (let count = 0; count < steps && !playing.isOver; count += 1) {
    const read = (seat: Seat): Controls =>
      playing.seats?.bots.includes(seat) ? game.bot(playing.state, seat) : controls(seat);
    game.step(playing.state, read, settings);
    playing.step! += 1;
    playing.isOver = game.isOver(playing.state);
  }
  return {
    outputs: { state: { string: describe(game, playing) }, ...feedbackOutputs(game, playing) },
  };
}

function readPlan(game: Game<unknown>, text: string | undefined, playing: Playing): void {
  if (text === undefined || text === playing.planText) return;
  playing.planText = text;
  const plan = readJson(text, isRoundPlan);
  if (!plan || plan.game !== game.id || plan.id === playing.plan?.id) return;
  playing.plan = plan;
  playing.state = plan.resume?.state ?? game.start(plan);
  playing.step = plan.resume?.step ?? 0;
  playing.isOver = false;
  playing.presses = {};
  playing.answers = {};
  playing.sent = {};
}

function readSeats(text: string | undefined, playing: Playing): void {
  if (text === undefined || text === playing.seatsText) return;
  playing.seatsText = text;
  playing.seats = readJson(text, isRoundSeats) ?? playing.seats;
}

function readJson<T>(text: string, isIt: (value: unknown) => value is T): T | undefined {
  try {
    const value: unknown = JSON.parse(text);
    return isIt(value) ? value : undefined;
  } catch {
    return undefined;
  }
}

function readSettings(game: Game<unknown>, inputs: RoundInputs): Record<string, number> {
  return Object.fromEntries(
    Object.entries(game.settings).map(([name, fallback]) => {
      const { double, float, int32 } = (inputs[name] ?? {}) as Record<string, number | undefined>;
      const value = double ?? float ?? int32 ?? fallback;
      return [name, Number.isFinite(value) ? Math.min(MAX_SETTING, Math.max(0, value)) : fallback];
    }),
  );
}

/** The controls of each seat in this run, from what its client says. */
function readControls(
  { sticks, buttons, pressed, answers }: RoundInputs,
  playing: Playing,
  nowMs: number,
): (seat: Seat) => Controls {
  const bySeat = new Map<Seat, Controls>();
  for (const [key, client] of Object.entries(playing.seats?.clients ?? {})) {
    const seat = Number(key);
    const { x = 0, y = 0 } = elementOf(sticks, client)?.vector2 ?? {};
    const { isNew, pressedAtMs } = readPress(elementOf(pressed, client), playing, seat, nowMs);
    const answer = judgeAnswer(elementOf(answers, client), playing, seat, nowMs);
    bySeat.set(seat, {
      x: toShare(x),
      y: toShare(y),
      // A tap may be over before the step that looks at the button
      isPressed: isNew || elementOf(buttons, client)?.bool === true,
      ...(pressedAtMs !== undefined && { pressedAtMs }),
      ...(answer && { answer }),
    });
  }
  return (seat) => bySeat.get(seat) ?? { ...AT_REST, isAway: true };
}

const elementOf = <T>(
  list: List<T> | undefined,
  client: string,
): List<T>['elements'][number] | undefined =>
  list?.elements.find(({ identity }) => identity === client);

/** When a seat pressed last, milliseconds since the start, and whether that is new. */
function readPress(
  press: { readonly double?: number; readonly receivedAtMs?: number } | undefined,
  { presses, seats, plan }: Playing,
  seat: Seat,
  nowMs: number,
): { readonly isNew: boolean; readonly pressedAtMs?: number } {
  const { double: claimedMs, receivedAtMs = nowMs } = press ?? {};
  if (claimedMs === undefined || !(Math.abs(claimedMs - receivedAtMs) < OLDEST_PRESS_MS))
    return { isNew: false };
  const delay = seats?.delays?.[seat];
  const { judgedMs, isNew } = judgeOnce(presses!, seat, claimedMs, receivedAtMs, delay);
  if (judgedMs <= nowMs - OLDEST_PRESS_MS) return { isNew: false };
  return { isNew, pressedAtMs: judgedMs - plan!.startsAtMs };
}

/** The newest answer of a seat, with the time of its first record: the result comes later, with the same time. */
function judgeAnswer(
  record: (AnswerRecord & { readonly receivedAtMs?: number }) | undefined,
  { answers, seats, plan }: Playing,
  seat: Seat,
  nowMs: number,
): Answer | undefined {
  const { startsAtMs } = plan!;
  const answer = readAnswer(record, nowMs, startsAtMs);
  if (!answer) return undefined;
  const { receivedAtMs = nowMs } = record!;
  const claimedMs = answer.atMs + startsAtMs;
  const delay = seats?.delays?.[seat];
  const { judgedMs } = judgeOnce(answers!, seat, claimedMs, receivedAtMs, delay);
  if (judgedMs === claimedMs) return answer;
  return { ...answer, atMs: judgedMs - startsAtMs, claimedAtMs: answer.atMs };
}

const toShare = (value: number): number =>
  Number.isFinite(value) ? Math.min(1, Math.max(-1, value)) : 0;

function describe(game: Game<unknown>, playing: Playing): string {
  const { plan, step, state, isOver } = playing;
  const places = game.places(state);
  return JSON.stringify({ id: plan!.id, step, state, places, isOver } as RoundState);
}

/** Feedback for the phones: at its interval, after a hit and at the end. */
function feedbackOutputs(game: Game<unknown>, playing: Playing): RoundOutputs['outputs'] {
  const isTime = playing.step! % STEPS_BETWEEN_FEEDBACK === 0 || playing.isOver;
  const elements: { string: string; outputTopicParams: string[] }[] = [];
  for (const [seat, client] of Object.entries(playing.seats?.clients ?? {})) {
    const feedback = game.feedback(playing.state, Number(seat));
    const before = playing.sent![client];
    if (!isTime && before?.hitAt === feedback.hitAt) continue;
    const text = JSON.stringify(feedback);
    if (text === before?.text) continue;
    playing.sent![client] = { text, hitAt: feedback.hitAt };
    elements.push({ string: text, outputTopicParams: [client] });
  }
  return elements.length > 0 ? { feedback: { elements } } : {};
}
