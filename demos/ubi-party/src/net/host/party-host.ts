import type { UbiiClient } from '@ubii/client-web';
import { takesAnswers, type RoundState } from '../../modules/index.ts';
import {
  gameOf,
  nextRoom,
  type GameId,
  type Player,
  type Room,
  type RoomEvent,
  type Seat,
  toRoom,
} from '../../sim/index.ts';
import { PhotoBoard } from './photo-board.ts';
import {
  LIVE_TOPIC,
  phoneOf,
  ROOM_TOPIC,
  ROUND_TOPIC,
  SEATS_TOPIC,
  settingTopic,
  type RoomView,
} from '../protocol.ts';
import { Audience } from './audience.ts';
import { Crowding } from './crowding.ts';
import { DelayWatch } from './phone-delays.ts';
import { GameSessions } from './game-sessions.ts';
import { EMPTY_MEMORY, type PartyHostOptions } from './party-host-options.ts';
import { PhoneRequests } from './phone-requests.ts';
import { Presence } from './presence.ts';
import { RoomPublisher, sinceMsOf } from './room-publisher.ts';
import { RoundLeader, publishSettings, settingTopics } from './round-leader.ts';

const TICK_MS = 250;
const SAVE_STATE_MS = 1000;

/**
 * Leads a party: keeps the room, starts the session of each game, and publishes both. It runs in the page of the big screen,
 * or in a program without a screen. Its state is stored, and published on topics.
 */
export class PartyHost {
  readonly #options: PartyHostOptions;
  readonly #client: UbiiClient;
  readonly #sessions: GameSessions;
  readonly #photos: PhotoBoard;
  readonly #presence = new Presence();
  readonly #delays: DelayWatch;
  readonly #publisher: RoomPublisher;
  readonly #rounds: RoundLeader;
  readonly #requests: PhoneRequests;
  readonly #audience: Audience;
  readonly #ends: (() => void)[] = [];
  readonly #storedSinceMs: number;
  #room: Room;
  #savedRoom: Room | undefined;
  #savedAtMs = -Infinity;
  #isClosed = false;

  constructor(options: PartyHostOptions) {
    this.#options = options;
    this.#client = options.client;
    const memory = options.storage.load() ?? EMPTY_MEMORY;
    const { room, round, state, arePhotosHidden = false, sinceMs = 0 } = memory;
    this.#room = toRoom(room);
    this.#storedSinceMs = sinceMs;
    this.#photos = new PhotoBoard(
      {
        client: options.client,
        isPlayer: (id) => this.#room.players.some(({ key }) => key === id),
        handleChange: () => this.#handlePhotos(),
      },
      arePhotosHidden,
    );
    const { client, clock, drawByte } = options;
    const keys = (): string[] => this.#room.players.flatMap(({ key }) => key ?? []);
    this.#delays = new DelayWatch({ client, clock, keys });
    this.#publisher = new RoomPublisher({
      client,
      clock,
      handleSuperseded: (byId) => {
        this.close();
        options.listener.handleSuperseded?.(byId);
      },
    });
    this.#rounds = new RoundLeader(
      { client, drawByte, handleState: (game, next) => this.#handleState(game, next) },
      { ...(round && { round }), ...(state && { state }) },
    );
    this.#audience = new Audience({
      client,
      nowMs: () => this.#nowMs(),
      room: () => this.#room,
      handleCheer: (cheer) => options.listener.handleCheer?.(cheer),
    });
    const crowding = new Crowding({
      client,
      room: () => this.#room,
      remove: (key) => this.#decide(key, { type: 'leave', key }),
    });
    this.#requests = new PhoneRequests({
      client,
      drawByte,
      nowMs: () => this.#nowMs(),
      hasSeat: (key) => this.#room.players.some((player) => player.key === key),
      decide: (key, event) => this.#decide(key, event),
      makeRoom: (key, as) => crowding.makeRoom(key, as),
    });
    this.#sessions = new GameSessions(options.client, (sentence) =>
      options.listener.handleTrouble?.(sentence),
    );
  }

  get view(): RoomView {
    const lags = this.#presence.lags(this.#room.players, this.#nowMs(), (key) =>
      this.#delays.delays.lagOf(key),
    );
    const { id } = this.#client;
    const { hidden } = this.#photos;
    const { round } = this.#rounds;
    const { sinceMs } = this.#publisher;
    return {
      room: this.#room,
      hostId: id,
      ...(sinceMs !== undefined && { sinceMs }),
      lags,
      ...(round && { round }),
      ...((hidden.all || hidden.ids.length > 0) && { hiddenPhotos: hidden }),
    };
  }

  /** Begins to lead, with what was stored. The client is connected. */
  async start(): Promise<void> {
    const rooms = this.#publisher.open();
    this.#ends.push(() => rooms.close());
    try {
      this.#adopt(await rooms.before);
      if (!this.#isClosed) await this.#listenToPhones();
    } catch (cause) {
      if (!this.#isClosed) throw cause;
    }
    if (this.#isClosed) return;
    this.#publisher.lead();
    const stopState = this.#client.onState(({ status }) => {
      if (status === 'connected') void this.#handleConnected();
    });
    const stopTicks = this.#options.clock.every(TICK_MS, () => this.#tick());
    this.#ends.push(stopState, stopTicks, this.#delays.start());
    await this.#handleConnected();
    this.#publish();
  }

  async #listenToPhones(): Promise<void> {
    const requests = this.#requests.open();
    const audience = this.#audience.open();
    const here = this.#client.subscribe({ glob: '/*/party/here' }, { format: 'double' });
    here.onRecord(({ topic, value }) => {
      const key = phoneOf(topic, 'here');
      if (key !== undefined) this.#handleHere(key, value);
    });
    this.#ends.push(
      () => requests.close(),
      () => audience.close(),
      () => void here.close(),
    );
    await Promise.all([requests.ready, audience.ready, here.ready]);
  }

  /** Number of cheers dropped by the rate limit and not shown. */
  get droppedCheers(): number {
    return this.#audience.dropped;
  }

  /** Applies an event of the host itself; those of leading phones arrive as requests. @throws RoomRefusal */
  apply(event: RoomEvent): void {
    this.#become(nextRoom(this.#room, event, this.#nowMs()));
  }

  /** A code with which another phone takes a seat over; undefined for a seat without a person. */
  offerSeat(seat: Seat): string | undefined {
    const key = this.#room.players.find((player) => player.seat === seat)?.key;
    return key === undefined ? undefined : this.#requests.offer(key);
  }

  /** Changes a setting of a game for everybody, now. */
  setSetting(game: GameId, setting: string, value: number): void {
    const event = { type: 'set-setting', by: 'host', game, setting, value } as const;
    // A slider changes many times a second: the next tick saves and publishes it
    this.#room = nextRoom(this.#room, event, this.#nowMs());
    this.#client.publish(settingTopic(game, setting), 'double', value);
  }

  /** Takes the photo of a seat off the big screen, for everybody. */
  takeDownPhoto(seat: Seat): void {
    const key = this.#room.players.find((player) => player.seat === seat)?.key;
    if (key !== undefined) this.#photos.takeDown(key);
  }

  /** No photos on the big screen, until a message allows them again. */
  hidePhotos(areHidden: boolean): void {
    this.#photos.hideAll(areHidden);
    this.#save();
  }

  /** Leads no longer. The sessions and the retained topics stay, so that another screen can continue. */
  close(): void {
    if (this.#isClosed) return;
    this.#isClosed = true;
    for (const end of this.#ends) end();
    this.#photos.close();
    this.#rounds.close();
  }

  /** Ends the party: sessions, and what the topics say. */
  async end(): Promise<void> {
    this.close();
    const topics = [ROOM_TOPIC, ROUND_TOPIC, SEATS_TOPIC, LIVE_TOPIC, ...settingTopics()];
    for (const topic of topics) this.#client.endTopic(topic);
    this.#options.storage.save(EMPTY_MEMORY);
    await this.#sessions.removeAll();
  }

  #nowMs(): number {
    return this.#client.masterTime.nowMs();
  }

  #decide(key: string, event: RoomEvent): void {
    this.apply(event);
    if (event.type === 'leave' || event.type === 'away') this.#presence.forget(key);
    else if (this.#personOf(key)) this.#presence.record(key, 0, this.#nowMs());
  }

  /** Clients without a place are not remembered: there may be any number of them. */
  #handleHere(key: string, lagMs: number): void {
    const one = this.#personOf(key);
    if (!one) return;
    this.#presence.record(key, lagMs, this.#nowMs());
    if (one.awaySinceMs !== undefined) this.apply({ type: 'back', key });
  }

  #personOf(key: string): Pick<Player, 'awaySinceMs'> | undefined {
    return peopleOf(this.#room).find((one) => one.key === key);
  }

  /** Continues with the party that another screen has led, when this one knows none or has led before it. */
  #adopt(view: RoomView | undefined): void {
    const players: unknown = view?.room?.players;
    if (!view || !Array.isArray(players) || players.length === 0) return;
    const isNewer = sinceMsOf(view) > this.#storedSinceMs;
    if (this.#room.players.length > 0 && !isNewer) return;
    this.#room = toRoom(view.room);
    this.#rounds.adopt(view.round);
  }

  /** New, or again: the master may have lost the session, and with it the round. */
  async #handleConnected(): Promise<void> {
    publishSettings(this.#client, this.#room);
    const game = gameOf(this.#room) as GameId | undefined;
    const { phase } = this.#room;
    if (game === undefined || phase === 'lobby' || phase === 'end') return;
    this.#listenTo(game);
    const isNew = await this.#sessions.open(game);
    if (this.#isClosed) return;
    if (isNew && phase === 'play') this.#rounds.resume(this.#nowMs());
    this.#publish();
  }

  #become(room: Room): void {
    const before = this.#room;
    if (room === before) return;
    this.#room = room;
    if (room.phase !== before.phase) this.#enter(room);
    this.#publish();
    this.#save();
  }

  #enter(room: Room): void {
    const game = gameOf(room) as GameId | undefined;
    if (game === undefined) return;
    if (room.phase === 'explanation') {
      this.#rounds.clear();
      this.#audience.clear();
      this.#listenTo(game);
      void this.#sessions.open(game).then(() => this.#publish());
    }
    if (room.phase === 'podium') this.#photos.close();
    if (room.phase === 'countdown') this.#rounds.plan(game, room, room.endsAtMs ?? this.#nowMs());
    if (room.phase === 'lobby' || room.phase === 'end') {
      this.#photos.close();
      this.#rounds.clear();
      this.#audience.clear();
      void this.#sessions.removeAll();
    }
  }

  #listenTo(game: GameId): void {
    this.#rounds.listenTo(game);
    if (takesAnswers(game)) this.#photos.open();
  }

  #handlePhotos(): void {
    this.#options.listener.handlePhotos?.(this.#photos.photos);
    this.#publish();
  }

  #handleState(game: GameId, state: RoundState): void {
    this.#options.listener.handleState?.(game, state);
    this.#audience.handleState(game, state);
    if (this.#room.phase === 'countdown') this.apply({ type: 'time' });
    if (state.isOver && this.#room.phase === 'play')
      this.apply({ type: 'round-over', places: state.places });
    else if (this.#nowMs() - this.#savedAtMs > SAVE_STATE_MS) this.#save();
  }

  #tick(): void {
    const nowMs = this.#nowMs();
    for (const { key, awaySinceMs } of peopleOf(this.#room)) {
      if (key === undefined || awaySinceMs !== undefined) continue;
      if (!this.#presence.isHere(key, nowMs)) this.apply({ type: 'away', key });
    }
    this.apply({ type: 'time' });
    this.#presence.tidy(nowMs);
    if (this.#room !== this.#savedRoom) this.#save();
    this.#publish();
  }

  #publish(): void {
    if (this.#isClosed || this.#publisher.sinceMs === undefined) return;
    this.#rounds.publishSeats(this.#room, (key) => this.#delays.delays.of(key));
    this.#rounds.setSession((game) => this.#sessions.idOf(game));
    const view = this.view;
    if (this.#publisher.publish(view)) this.#options.listener.handleView?.(view);
  }

  #save(): void {
    this.#savedAtMs = this.#nowMs();
    const { round, state } = this.#rounds;
    const room = this.#room;
    this.#savedRoom = room;
    const { sinceMs } = this.#publisher;
    const { all: arePhotosHidden } = this.#photos.hidden;
    this.#options.storage.save({
      room,
      ...(sinceMs !== undefined && { sinceMs }),
      ...(arePhotosHidden && { arePhotosHidden }),
      ...(round && { round }),
      ...(state && { state }),
    });
  }
}

/** All who may be away: players, bots and spectators. */
const peopleOf = ({
  players,
  spectators,
}: Room): readonly Pick<Player, 'key' | 'awaySinceMs'>[] => [...players, ...spectators];
