import type { Controller, Feedback } from './feedback.ts';
import type { Hud } from './hud.ts';
import type { Seat } from './seat.ts';
export type { Seat } from './seat.ts';

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
  /** How sure the phone is, 0 to 1. */
  readonly score: number;
  /** When the player acted, milliseconds since the start of the round on the master's clock. It also identifies the answer. */
  readonly atMs: number;
  /** What the phone said of that time, where its arrival contradicts it; its photo has this one. */
  readonly claimedAtMs?: number;
  /** Where it is in the picture. */
  readonly area?: Area;
}

/** What a controller says in one step. */
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

/** What a round begins with. The same setup and the same controls give the same round. */
export interface RoundSetup {
  readonly seats: readonly Seat[];
  /** Any 32-bit integer. */
  readonly seed: number;
  /** Times to answer are so many times as long, for all players. @default 1 */
  readonly pace?: number;
}

/** What a state of a game with times to answer keeps of its setup. */
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
  /** What the game is about and how it is played, for the 20 seconds before it. */
  readonly explanation: readonly string[];
  /** What it is played with. */
  readonly controller: Controller;
  /** What can be changed while it runs, with the values it has at first. */
  readonly settings: Settings;
  /** Settings that are on (1) or off (0), with the words for people. */
  readonly switches?: Readonly<Record<string, string>>;
  start(setup: RoundSetup): State;
  /** Changes the state to that of one step later. */
  step(state: State, controls: ReadControls, settings: Settings): void;
  isOver(state: State): boolean;
  /** Of the state as it is now: the running table, and the result once it is over. */
  places(state: State): Places;
  /** How a player stands, for the phone. */
  feedback(state: State, seat: Seat): Feedback;
  /** What the big screen says of the round. @param nameOf the name of a seat */
  hud(state: State, nameOf: (seat: Seat) => string): Hud;
  /** The controls of a bot on a seat. */
  bot(state: State, seat: Seat): Controls;
  /** Where the pieces stand: the picture of a game that has no scene of its own. */
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

/** Numbers that people change while a game runs: 1 is as the game is meant. */
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
