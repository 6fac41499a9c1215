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
  LIVE_TOPIC,
  ROOM_TOPIC,
  settingTopic,
  readJson,
  ROUND_TOPIC,
  SEATS_TOPIC,
  stateTopic,
  type RoundView,
} from '../protocol.ts';
import { GameSessions } from './game-sessions.ts';
import type { HostMemory } from './party-host-options.ts';

/** Publishes the settings that differ from the default of their game: a restarted master has lost them. */
export function publishSettings(client: UbiiClient, { settings }: Room): void {
  for (const [game, values] of Object.entries(settings)) {
    for (const [name, value] of Object.entries(values))
      client.publish(settingTopic(game, name), 'double', value);
  }
}

/** All topics of a party that the master retains; a setting that was changed back to its default has a value, too. */
export function retainedTopics(): string[] {
  const settings = Object.values(GAMES).flatMap((game) =>
    Object.keys(game.settings).map((name) => settingTopic(game.id, name)),
  );
  return [ROOM_TOPIC, ROUND_TOPIC, SEATS_TOPIC, LIVE_TOPIC, ...settings];
}

/** The round continues this long after a restart of its module, milliseconds. */
const RESUME_IN_MS = 3000;

export interface RoundLeaderOptions {
  readonly client: UbiiClient;
  /** A random integer from 0 to 255. */
  readonly drawByte: () => number;
  handleState(game: GameId, state: RoundState): void;
  /** @param sentence why a session failed */
  readonly handleTrouble: (sentence: string) => void;
}

/** Controls the module of a game: publishes the round, its seats and settings, and follows its state. */
export class RoundLeader {
  readonly #options: RoundLeaderOptions;
  readonly #client: UbiiClient;
  #round: RoundView | undefined;
  #state: RoundState | undefined;
  #states: Subscription<'string'> | undefined;
  #seatsText = '';
  readonly #sessions: GameSessions;
  #isClosed = false;

  constructor(options: RoundLeaderOptions, { round, state }: Pick<HostMemory, 'round' | 'state'>) {
    this.#options = options;
    this.#client = options.client;
    this.#sessions = new GameSessions(options.client, options.handleTrouble);
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

  /** A game is explained: opens its session, and follows its states. */
  async prepare(game: GameId): Promise<void> {
    this.#clear();
    this.#follow(game);
    await this.#sessions.open(game);
  }

  /** Opens the session again after a lost connection: the master may have lost it, and with it the round. */
  async continue(game: GameId, isPlaying: boolean): Promise<void> {
    this.#follow(game);
    const isNew = await this.#sessions.open(game);
    if (isNew && isPlaying && !this.#isClosed) this.#resume(this.#client.masterTime.nowMs());
  }

  /** No game is played: removes the sessions. */
  end(): Promise<void> {
    this.#clear();
    return this.#sessions.removeAll();
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
  #resume(nowMs: number): void {
    const round = this.#round;
    if (!round) return;
    const { step = 0, state } = this.#state?.id === round.id ? this.#state : {};
    const id = `${round.id.split('~')[0]}~${nowMs}`;
    const startsAtMs = nowMs + RESUME_IN_MS - (step * 1000) / STEPS_PER_SECOND;
    this.#round = { ...round, id, startsAtMs };
    this.#publishPlan(state === undefined ? undefined : { step, state });
  }

  /** Notes in which session the round is played. */
  updateSession(): void {
    const round = this.#round;
    const sessionId = round && this.#sessions.idOf(round.game as GameId);
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
    this.#isClosed = true;
    this.#stopFollowing();
  }

  #clear(): void {
    this.#round = undefined;
    this.#state = undefined;
  }

  #follow(game: GameId): void {
    this.#stopFollowing();
    this.#states = this.#client.subscribe(stateTopic(game), { format: 'string' });
    this.#states.onRecord(({ value }) => this.#handleState(game, value));
  }

  #stopFollowing(): void {
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
