import type { UbiiClient, Subscription } from '@ubii/client-web';

import type { PhoneDelay, RoundPlan, RoundSeats, RoundState } from '../../modules/index.ts';
import {
  GAMES,
  PACES,
  playersOf,
  STEPS_PER_SECOND,
  type Room,
  type GameId,
  type Seat,
} from '../../sim/index.ts';
import {
  settingTopic,
  readJson,
  ROUND_TOPIC,
  SEATS_TOPIC,
  stateTopic,
  type RoundView,
} from '../protocol.ts';
import type { HostMemory } from './party-host-options.ts';

/** Publishes the settings that differ from the default of their game: a restarted master has lost them. */
export function publishSettings(client: UbiiClient, { settings }: Room): void {
  for (const [game, values] of Object.entries(settings)) {
    for (const [name, value] of Object.entries(values))
      client.publish(settingTopic(game, name), 'double', value);
  }
}

/** The topics of all settings: one that was changed back to its default has a value, too. */
export function settingTopics(): string[] {
  return Object.values(GAMES).flatMap(({ id, settings }) =>
    Object.keys(settings).map((name) => settingTopic(id, name)),
  );
}

/** The round continues this long after a restart of its module, milliseconds. */
const RESUME_IN_MS = 3000;

export interface RoundLeaderOptions {
  readonly client: UbiiClient;
  /** A random integer from 0 to 255. */
  readonly drawByte: () => number;
  handleState(game: GameId, state: RoundState): void;
}

/** Controls the module of a game: publishes the round, its seats and settings, and follows its state. */
export class RoundLeader {
  readonly #options: RoundLeaderOptions;
  readonly #client: UbiiClient;
  #round: RoundView | undefined;
  #state: RoundState | undefined;
  #states: Subscription<'string'> | undefined;
  #seatsText = '';

  constructor(options: RoundLeaderOptions, { round, state }: Pick<HostMemory, 'round' | 'state'>) {
    this.#options = options;
    this.#client = options.client;
    this.#round = round;
    this.#state = state;
  }

  get round(): RoundView | undefined {
    return this.#round;
  }

  /** The newest state that came. */
  get state(): RoundState | undefined {
    return this.#state;
  }

  /** Continues with a round that another screen has planned. */
  adopt(round: RoundView | undefined): void {
    this.#round = round;
  }

  /** Follows the states of a game. */
  listenTo(game: GameId): void {
    this.close();
    this.#states = this.#client.subscribe(stateTopic(game), { format: 'string' });
    this.#states.onRecord(({ value }) => this.#handleState(game, value));
  }

  /** Says when the round starts, and with whom. */
  plan(game: GameId, room: Room, startsAtMs: number): void {
    const [a, b, c] = [0, 0, 0].map(() => this.#options.drawByte()) as [number, number, number];
    const seed = (a << 16) | (b << 8) | c;
    const seats = playersOf(room).map(({ seat }) => seat);
    this.#state = undefined;
    const id = `${game}-${startsAtMs}-${seed}`;
    const pace = PACES[room.pace];
    this.#round = { id, game, seed, startsAtMs, seats, ...(pace !== 1 && { pace }) };
    this.#publishPlan(undefined);
  }

  /** The module was started again: it continues from the newest state that came here. */
  resume(nowMs: number): void {
    const round = this.#round;
    if (!round) return;
    const { step = 0, state } = this.#state?.id === round.id ? this.#state : {};
    const id = `${round.id.split('~')[0]}~${nowMs}`;
    const startsAtMs = nowMs + RESUME_IN_MS - (step * 1000) / STEPS_PER_SECOND;
    this.#round = { ...round, id, startsAtMs };
    this.#publishPlan(state === undefined ? undefined : { step, state });
  }

  /** There is no round. */
  clear(): void {
    this.#round = undefined;
    this.#state = undefined;
  }

  /** In which session it is played. */
  setSession(idOf: (game: GameId) => string | undefined): void {
    const round = this.#round;
    const sessionId = round && idOf(round.game as GameId);
    if (!round || sessionId === round.sessionId) return;
    this.#round = { ...round, ...(sessionId !== undefined && { sessionId }) };
  }

  /** Publishes who plays now: the present phones with their delays, and bots. */
  publishSeats(room: Room, delayOf: (key: string) => PhoneDelay | undefined): void {
    const clients: Record<Seat, string> = {};
    const delays: Record<Seat, PhoneDelay> = {};
    const bots: Seat[] = [];
    for (const { seat, key, awaySinceMs } of playersOf(room)) {
      if (key === undefined) bots.push(seat);
      else if (awaySinceMs === undefined) {
        clients[seat] = key;
        const delay = delayOf(key);
        if (delay) delays[seat] = delay;
      }
    }
    const seats: RoundSeats = { clients, bots, delays };
    const text = JSON.stringify(seats);
    if (text === this.#seatsText) return;
    this.#seatsText = text;
    this.#client.publish(SEATS_TOPIC, 'string', text, { immediate: true });
  }

  close(): void {
    void this.#states?.close();
    this.#states = undefined;
  }

  #publishPlan(resume: RoundPlan['resume']): void {
    const { sessionId: _, ...round } = this.#round!;
    const plan: RoundPlan = { ...round, ...(resume && { resume }) };
    this.#client.publish(ROUND_TOPIC, 'string', JSON.stringify(plan), { immediate: true });
  }

  #handleState(game: GameId, text: string): void {
    const state = readJson<RoundState>(text);
    if (state?.id === undefined || state.id !== this.#round?.id) return;
    if (!Array.isArray(state.places) || typeof state.step !== 'number') return;
    this.#state = state as RoundState;
    this.#options.handleState(game, this.#state);
  }
}
