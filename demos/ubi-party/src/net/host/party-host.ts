import type { UbiiClient } from '@ubii/client-web';
import { takesAnswers, type RoundState } from '../../modules/index.ts';
import {
  gameOf,
  nextRoom,
  type GameId,
  type Room,
  type RoomEvent,
  type Seat,
  toRoom,
} from '../../sim/index.ts';
import { settingTopic, type RoomView } from '../protocol.ts';
import { Audience } from './audience.ts';
import { EMPTY_MEMORY, type PartyHostOptions } from './party-host-options.ts';
import { PhoneRequests } from './phone-requests.ts';
import { PhotoBoard } from './photo-board.ts';
import { Presence } from './presence.ts';
import { RoomPublisher, sinceMsOf } from './room-publisher.ts';
import { RoundLeader, publishSettings, retainedTopics } from './round-leader.ts';

const TICK_MS = 250;
const SAVE_STATE_MS = 1000;

/**
 * Leads a party: keeps the room, starts the session of each game, and publishes both. It runs in the page of the big screen,
 * or in a program without a screen. Its state is stored, and published on topics.
 */
export class PartyHost {
  readonly #options: PartyHostOptions;
  readonly #client: UbiiClient;
  readonly #photos: PhotoBoard;
  readonly #presence: Presence;
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
    const { client, clock, drawByte, listener } = options;
    const shared = { client, nowMs: () => this.#nowMs(), room: () => this.#room };
    this.#photos = new PhotoBoard(
      {
        client,
        isPlayer: (id) => this.#room.players.some(({ key }) => key === id),
        handleChange: () => {
          listener.handlePhotos?.(this.#photos.photos);
          this.#publish();
        },
      },
      arePhotosHidden,
    );
    this.#presence = new Presence({ ...shared, clock, apply: (event) => this.apply(event) });
    this.#publisher = new RoomPublisher({
      client,
      clock,
      handleSuperseded: (byId) => {
        this.close();
        listener.handleSuperseded?.(byId);
      },
    });
    this.#rounds = new RoundLeader(
      {
        client,
        drawByte,
        handleState: (game, next) => this.#handleState(game, next),
        handleTrouble: (sentence) => listener.handleTrouble?.(sentence),
      },
      { ...(round && { round }), ...(state && { state }) },
    );
    this.#audience = new Audience({
      ...shared,
      handleCheer: (cheer) => listener.handleCheer?.(cheer),
    });
    this.#requests = new PhoneRequests({
      ...shared,
      drawByte,
      decide: (key, event) => this.#decide(key, event),
    });
  }

  get view(): RoomView {
    const { hidden } = this.#photos;
    const { round } = this.#rounds;
    const { sinceMs } = this.#publisher;
    return {
      room: this.#room,
      hostId: this.#client.id,
      ...(sinceMs !== undefined && { sinceMs }),
      lags: this.#presence.lags(),
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
    this.#ends.push(stopState, stopTicks);
    await this.#handleConnected();
    this.#publish();
  }

  async #listenToPhones(): Promise<void> {
    const requests = this.#requests.open();
    const audience = this.#audience.open();
    const presence = this.#presence.open();
    this.#ends.push(
      () => requests.close(),
      () => audience.close(),
      () => presence.close(),
    );
    await Promise.all([requests.ready, audience.ready, presence.ready]);
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
    const key = this.#keyOf(seat);
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
    const key = this.#keyOf(seat);
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
    for (const topic of retainedTopics()) this.#client.endTopic(topic);
    this.#options.storage.save(EMPTY_MEMORY);
    await this.#rounds.end();
  }

  #keyOf(seat: Seat): string | undefined {
    return this.#room.players.find((player) => player.seat === seat)?.key;
  }

  #nowMs(): number {
    return this.#client.masterTime.nowMs();
  }

  #decide(key: string, event: RoomEvent): void {
    this.apply(event);
    this.#presence.handleRequest(key, event);
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
    this.#openPhotos(game);
    await this.#rounds.continue(game, phase === 'play');
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
      this.#audience.clear();
      this.#openPhotos(game);
      void this.#rounds.prepare(game).then(() => this.#publish());
    }
    if (room.phase === 'podium') this.#photos.close();
    if (room.phase === 'countdown') this.#rounds.plan(game, room, room.endsAtMs ?? this.#nowMs());
    if (room.phase === 'lobby' || room.phase === 'end') {
      this.#photos.close();
      this.#audience.clear();
      void this.#rounds.end();
    }
  }

  #openPhotos(game: GameId): void {
    if (takesAnswers(game)) this.#photos.open();
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
    this.#presence.update();
    this.apply({ type: 'time' });
    if (this.#room !== this.#savedRoom) this.#save();
    this.#publish();
  }

  #publish(): void {
    if (this.#isClosed || this.#publisher.sinceMs === undefined) return;
    this.#rounds.publishSeats(this.#room, (key) => this.#presence.delayOf(key));
    this.#rounds.updateSession();
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
