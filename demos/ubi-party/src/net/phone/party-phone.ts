import type { Clock, Subscription, UbiiClient } from '@ubii/client-web';
import type { PhoneFacts, PhoneLink } from './phone-link.ts';
import { toRoom, type Answer, type CheerKind, type Feedback } from '../../sim/index.ts';
import { readLiveRound, type LiveRound } from '../live-round.ts';
import {
  readJson,
  LIVE_TOPIC,
  PHONE_COMPONENTS,
  phoneTopic,
  ROOM_TOPIC,
  type HostReply,
  type PhoneRequest,
  type PhoneAction,
  type Photo,
  type RoomView,
} from '../protocol.ts';
import { ShownPhoto } from './shown-photo.ts';
import { PhoneDevices } from './phone-devices.ts';

/** A phone says once a second that it is there. */
const HERE_MS = 1000;
const ANSWER_WITHIN_MS = 5000;
const CHEER_STANDS_MS = 1000;

const NO_ANSWER = 'The big screen does not answer. Is its page still open?';

interface Waiting {
  resolve(reply: HostReply): void;
  reject(error: Error): void;
  readonly cancel: () => void;
}

/** The phone of a player as a client: a device with components, and the room as it is feedback. */
export class PartyPhone implements PhoneLink {
  readonly #client: UbiiClient;
  readonly #clock: Clock;
  readonly #listeners = new Set<() => void>();
  readonly #waiting = new Map<number, Waiting>();
  readonly #shownPhoto: ShownPhoto;
  readonly #devices: PhoneDevices;
  readonly #ends: (() => void)[] = [];
  #number = 0;
  #view: RoomView | undefined;
  #feedback: Feedback | undefined;
  #live: LiveRound | undefined;
  #lives: Subscription<'string'> | undefined;
  #isSeen = true;
  #steered = { x: 0, y: 0 };

  /** @param client connected, or soon */
  constructor(client: UbiiClient, clock: Clock) {
    this.#client = client;
    this.#clock = clock;
    this.#shownPhoto = new ShownPhoto(client, clock);
    this.#devices = new PhoneDevices(client);
    // Numbers continue after a reload of the page, so that an old reply matches no request
    this.#number = Math.floor(clock.nowMs());
  }

  /** Registers the device and follows the room. */
  async start(): Promise<void> {
    const client = this.#client;
    await this.#devices.open();
    this.#ends.push(() => this.#devices.close());
    this.#follow(client.id);
    this.#ends.push(
      client.onIdentityChange(({ clientId }) => this.#follow(clientId)),
      client.onState(() => this.#changed()),
      client.onRoundTrip(() => this.#changed()),
      this.#clock.every(HERE_MS, () => this.#sayHere()),
    );
    this.#sayHere();
  }

  get facts(): PhoneFacts {
    const { status } = this.#client.state;
    const { id } = this.#client;
    const { room, round } = this.#view ?? {};
    const me = room?.players.find(({ key }) => key === id);
    return {
      view: this.#view,
      me,
      spectator: room?.spectators.find(({ key }) => key === id),
      feedback: room?.phase === 'play' && me?.isWaiting === false ? this.#feedback : undefined,
      live: round && this.#live?.id === round.id ? this.#live : undefined,
      link: status === 'connected' ? 'connected' : status === 'connecting' ? 'connecting' : 'lost',
      masterUrl: this.#client.masterUrl,
      isInCluster: this.#client.otherMasters.length > 0,
      lagMs: this.#client.roundTrip?.lastMs,
      nowMs: () => this.#client.masterTime.nowMs(),
    };
  }

  onChange(fn: () => void): () => void {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  async ask(action: PhoneAction): Promise<{ readonly code?: string }> {
    this.#number += 1;
    const request: PhoneRequest = { number: this.#number, wish: action };
    const answer = new Promise<HostReply>((resolve, reject) => {
      const { number } = request;
      const cancel = this.#clock.after(ANSWER_WITHIN_MS, () => {
        this.#waiting.delete(number);
        reject(new Error(NO_ANSWER));
      });
      this.#waiting.set(number, { resolve, reject, cancel });
    });
    this.#publish('request', JSON.stringify(request));
    const { refusal, code } = await answer;
    if (refusal !== undefined) throw new Error(refusal);
    return code === undefined ? {} : { code };
  }

  steer(x: number, y: number): void {
    if (!this.#devices.isSeated) return;
    this.#steered = { x, y };
    this.#publish('stick', { x, y });
  }

  press(isDown: boolean): void {
    if (!this.#devices.isSeated) return;
    if (isDown) this.#publish('pressed', this.#client.masterTime.nowMs());
    this.#publish('button', isDown);
  }

  answer({ text, score, atMs, area }: Answer): void {
    if (!this.#devices.isSeated) return;
    this.#publish('answer', {
      id: text,
      pose: area && { position: { x: area.x, y: area.y } },
      size: area && { x: area.width, y: area.height },
      userDataJson: JSON.stringify({ score, atMs }),
    });
  }

  showPhoto(photo: Photo | undefined): void {
    if (this.#devices.isSeated || !photo) this.#shownPhoto.show(photo);
  }

  cheer(kind: CheerKind): void {
    // It is of the moment: a big screen that comes later does not show it
    this.#client.publish(phoneTopic(this.#client.id, 'cheer'), 'string', kind, {
      immediate: true,
      expiryMs: CHEER_STANDS_MS,
    });
  }

  /** The page is seen, or is not: who does not look at it is away, and steers nothing. */
  setSeen(isSeen: boolean): void {
    if (this.#isSeen === isSeen) return;
    this.#isSeen = isSeen;
    if (isSeen) {
      this.#sayHere();
      return;
    }
    this.press(false);
    if (this.#steered.x !== 0 || this.#steered.y !== 0) this.steer(0, 0);
    this.ask({ type: 'away' }).catch(() => undefined);
  }

  close(): void {
    this.#shownPhoto.show(undefined);
    for (const end of this.#ends) end();
    for (const { reject, cancel } of this.#waiting.values()) {
      cancel();
      reject(new Error('The page was left.'));
    }
    this.#waiting.clear();
  }

  #stopFollowing: (() => void) | undefined;

  /** Feedback and answers come on topics of the client, whose id another master may change. */
  #follow(clientId: string): void {
    this.#stopFollowing?.();
    const client = this.#client;
    const rooms = client.subscribe(ROOM_TOPIC, { format: 'string' });
    rooms.onRecord(({ value }) => {
      const view = readJson<RoomView>(value);
      if (!Array.isArray(view?.room?.players)) return;
      this.#view = { ...(view as RoomView), room: toRoom(view.room) };
      this.#shownPhoto.setHidden(this.#view.hiddenPhotos);
      this.#handleStanding();
      this.#changed();
    });
    const feedback = client.subscribe(phoneTopic(clientId, 'feedback'), { format: 'string' });
    feedback.onRecord(({ value }) => {
      const newest = readJson<Feedback>(value);
      if (typeof newest?.headline !== 'string') return;
      this.#feedback = newest as Feedback;
      this.#changed();
    });
    const replies = client.subscribe(phoneTopic(clientId, 'reply'), { format: 'string' });
    replies.onRecord(({ value }) => {
      const reply = readJson<HostReply>(value);
      if (typeof reply?.number === 'number') this.#handleReply(reply as HostReply);
    });
    this.#stopFollowing = () => {
      for (const one of [rooms, feedback, replies]) void one.close();
      void this.#lives?.close();
      this.#lives = undefined;
    };
    if (this.#ends.length === 1) this.#ends.push(() => this.#stopFollowing?.());
  }

  /** Adapts publications and subscriptions to whether the phone plays or watches. */
  #handleStanding(): void {
    const { me, spectator } = this.facts;
    if (this.#devices.setSeated(me !== undefined)) {
      if (me) {
        this.steer(0, 0);
        this.press(false);
      } else {
        this.#shownPhoto.show(undefined);
      }
    }
    const isWatching = spectator !== undefined || me?.isWaiting === true;
    if (isWatching === (this.#lives !== undefined)) return;
    void this.#lives?.close();
    this.#lives = isWatching ? this.#client.subscribe(LIVE_TOPIC, { format: 'string' }) : undefined;
    this.#live = undefined;
    this.#lives?.onRecord(({ value }) => {
      this.#live = readLiveRound(value);
      this.#changed();
    });
  }

  #handleReply(reply: HostReply): void {
    const waiting = this.#waiting.get(reply.number);
    this.#waiting.delete(reply.number);
    waiting?.cancel();
    waiting?.resolve(reply);
  }

  #sayHere(): void {
    if (this.#isSeen) this.#publish('here', this.#client.roundTrip?.lastMs ?? 0);
  }

  #publish(component: 'stick', value: { x: number; y: number }): void;
  #publish(component: 'button', value: boolean): void;
  #publish(component: 'pressed' | 'here', value: number): void;
  #publish(component: 'request', value: string): void;
  #publish(component: 'answer', value: object): void;
  #publish(component: keyof typeof PHONE_COMPONENTS, value: unknown): void {
    const { format } = PHONE_COMPONENTS[component];
    // Inputs of people are sent at once: buffering for 15 ms would cost a frame
    this.#client.publish(phoneTopic(this.#client.id, component), format, value as never, {
      immediate: true,
    });
  }

  #changed(): void {
    for (const fn of this.#listeners) fn();
  }
}
