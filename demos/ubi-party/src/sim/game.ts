/** A player's place in the room, from 0 to 31. It decides shape, colour and letter. */
export type Seat = number;

/**
 * State of the round for one player, sent to the phone. The texts come from the game, so that phones need no knowledge
 * of it.
 */
export interface Feedback {
  /** In the running table, from 1. */
  readonly place: number;
  /** Number of players. */
  readonly of: number;
  /** The largest words on the phone, such as `Lap 2 of 3`; at most 16 characters. */
  readonly headline: string;
  /** One sentence below it. */
  readonly sentence: string;
  /** Progress to the goal, 0 to 1: the ring around the token. */
  readonly progress: number;
  /** Level of the gauge on the pad, 0 to 1: stored boost, charge of a dash. */
  readonly gauge: number;
  /** Whole seconds, where the gauge is time that is left: the pad says them. */
  readonly secondsLeft?: number;
  /** The button does something now. */
  readonly isReady: boolean;
  /** Has nothing to steer any more in this round. */
  readonly isOut: boolean;
  /** The step of the newest hit, 0 for none: the phone vibrates when it changes. */
  readonly hitAt: number;
  /** The player's current question, in games with answers. */
  readonly question?: Question;
}

/** A question to the player. Times are milliseconds since the start of the round on the master's clock. */
export interface Question {
  /** The text of a right answer. */
  readonly text: string;
  /** For people, such as `a cup`. */
  readonly name: string;
  /** Of a right answer, at least. */
  readonly leastScore: number;
  readonly beganAtMs: number;
  readonly endsAtMs: number;
  /** An answer before this does not count. */
  readonly opensAtMs: number;
  /** Reward of a right answer at this moment, such as `3rd would be +1`. */
  readonly prize: string;
}

/** Input elements that the phone shows for a game. */
export interface Controller {
  /** wheel: left and right, by tilting or with the thumb; stick: all directions; none: only the button; camera: photos. */
  readonly steering: 'wheel' | 'stick' | 'none' | 'camera';
  /** On the button. */
  readonly button: string;
  /** A held button charges, letting it go acts. */
  readonly isHeld: boolean;
}

/** The place of a seat in a table, from 1. */
export function placeOf(places: readonly (readonly number[])[], seat: number): number {
  let before = 0;
  for (const seats of places) {
    if (seats.includes(seat)) return before + 1;
    before += seats.length;
  }
  return before + 1;
}

/** Texts on the big screen beside the picture of a round. They come from the game. */
export interface Hud {
  /** The largest words, such as `Lap 2 of 3`. */
  readonly headline: string;
  /** A statement to decide on, with what a step to the left and to the right means. */
  readonly question?: { readonly text: string; readonly left: string; readonly right: string };
  /** A few words behind each name, such as `+0.6 s`. */
  readonly notes: Readonly<Record<Seat, string>>;
  /** Those who are out: their names are dimmed. */
  readonly out: readonly Seat[];
  /** A number that counts down, or counts, and what it is of. */
  readonly corner?: { readonly value: string; readonly label: string };
  /** The newest event, shown for a second and a half. */
  readonly news?: { readonly seat: Seat; readonly sentence: string };
}

/** Display time of a piece of news, steps. */
export const NEWS_STEPS = 96;

/** Steps of a game per second, on every machine. */
export const STEPS_PER_SECOND = 60;
/** Seconds of one step. */
export const STEP_S = 1 / STEPS_PER_SECOND;

/** Presses of slow lines arrive so much later at most, milliseconds: games that go by the time of a press wait for them. */
export const WAIT_FOR_LATE_MS = 400;

/** A rectangle in a picture, as shares of its width and height from the top left. */
export interface Area {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A result that a phone found itself, such as what a photo shows. */
export interface Answer {
  /** Empty while the phone is still working on it. */
  readonly text: string;
  /** Confidence of the phone's detection, 0 to 1. */
  readonly score: number;
  /** When the player acted, milliseconds since the start of the round on the master's clock. It also identifies the answer. */
  readonly atMs: number;
  /** The time claimed by the phone, when its arrival contradicts it; the photo of the answer carries this time. */
  readonly claimedAtMs?: number;
  /** Bounding box in the picture. */
  readonly area?: Area;
}

/** Input of a controller in one step. */
export interface Controls {
  /** Stick or tilt, -1 (left) to 1 (right). */
  readonly x: number;
  /** Stick or tilt, -1 (towards the player) to 1 (away). */
  readonly y: number;
  /** The one button is down. */
  readonly isPressed: boolean;
  /** When the button went down last, milliseconds since the start of the round on the master's clock. */
  readonly pressedAtMs?: number;
  /** The newest one. */
  readonly answer?: Answer;
  /** The player of the seat is away: rounds do not wait for them. */
  readonly isAway?: boolean;
}

/** A controller without input: also that of a player who is away. */
export const AT_REST: Controls = { x: 0, y: 0, isPressed: false };

/** The controls of a seat in this step. */
export type ReadControls = (seat: Seat) => Controls;

/** Parameters of a round. The same setup and the same controls give the same round. */
export interface RoundSetup {
  readonly seats: readonly Seat[];
  /** Any 32-bit integer. */
  readonly seed: number;
  /** Times to answer are so many times as long, for all players. @default 1 */
  readonly pace?: number;
}

/** Part of the setup that the state of a game with answer times keeps. */
export interface WithPace {
  /** @default 1 */
  readonly pace?: number;
}

export function withPace({ pace = 1 }: RoundSetup): WithPace {
  return pace === 1 ? {} : { pace };
}

/** Seats by place, the best first; seats that share a place stand together. */
export type Places = readonly (readonly Seat[])[];

/**
 * A game: pure rules in fixed steps. A state is plain data (numbers, texts, arrays, objects), so that it can be
 * stored, hashed and sent. Only +, -, *, / and square roots are used: these give the same bits on every machine,
 * sine and cosine do not.
 */
export interface Game<State, Settings extends GameSettings = GameSettings> {
  /** In addresses and topics: lower case, letters and dashes. */
  readonly id: string;
  readonly title: string;
  /** Goal and controls of the game, shown before it until all players are ready or the time is over. */
  readonly explanation: readonly string[];
  /** Longest time of the explanation at the normal pace, milliseconds; without it, `EXPLANATION_MS`. */
  readonly explanationMs?: number;
  /** The input elements of the game. */
  readonly controller: Controller;
  /** Settings that can be changed during the game, with their defaults. */
  readonly settings: Settings;
  /** Settings that are on (1) or off (0), with the words for people. */
  readonly switches?: Readonly<Record<string, string>>;
  start(setup: RoundSetup): State;
  /** Changes the state to that of one step later. */
  step(state: State, controls: ReadControls, settings: Settings): void;
  isOver(state: State): boolean;
  /** Of the state as it is now: the running table, and the result once it is over. */
  places(state: State): Places;
  /** Feedback for the phone of a player. */
  feedback(state: State, seat: Seat): Feedback;
  /** State of the round for the big screen. @param nameOf the name of a seat */
  hud(state: State, nameOf: (seat: Seat) => string): Hud;
  /** The controls of a bot on a seat. */
  bot(state: State, seat: Seat): Controls;
  /** Positions of the pieces: the picture of a game without a scene of its own. */
  pieces?(state: State): readonly TablePiece[];
}

/** A player's piece on a table that reaches from -10 to 10 in both directions. */
export interface TablePiece {
  readonly seat: Seat;
  /** To the right. */
  readonly x: number;
  /** Away from who looks. */
  readonly y: number;
  /** Lies down. */
  readonly isOut: boolean;
}

/** Numbers that people change while a game runs: 1 is the default. */
export type GameSettings = Readonly<Record<string, number>>;

/** Groups seats that have the same score, the highest score first. */
export function placesByScore(
  seats: readonly Seat[],
  score: (seat: Seat) => number,
): readonly (readonly Seat[])[] {
  const groups = new Map<number, Seat[]>();
  for (const seat of seats) {
    const value = score(seat);
    const group = groups.get(value);
    if (group) group.push(seat);
    else groups.set(value, [seat]);
  }
  return [...groups].sort(([a], [b]) => b - a).map(([, group]) => group);
}
