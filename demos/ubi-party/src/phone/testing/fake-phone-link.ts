import type { LiveRound, Photo, PhoneAction, RoundView } from '../../net/index.ts';
import {
  EMPTY_ROOM,
  nextRoom,
  type Answer,
  type Asker,
  type CheerKind,
  type Feedback,
  type Room,
  type RoomEvent,
} from '../../sim/index.ts';
import type { PhoneFacts, PhoneLink } from '../../net/phone/phone-link.ts';

const KEY = 'this-phone';

/** State of the party, set by a test. */
export interface FakeParty {
  readonly room: Room;
  readonly round?: RoundView;
  readonly feedback?: Feedback;
  readonly live?: LiveRound;
  readonly link: PhoneFacts['link'];
  readonly lagMs?: number;
  readonly masterUrl?: string;
}

/** A phone whose host is the rules of the room: actions change it, refusals are those of the rules. */
export class FakePhoneLink implements PhoneLink {
  party: FakeParty;
  readonly asked: PhoneAction[] = [];
  /** The sent controls in their order: steering or a press. */
  readonly sent: ({ readonly x: number; readonly y: number } | boolean)[] = [];
  readonly answers: Answer[] = [];
  readonly cheers: CheerKind[] = [];
  /** The photos shown on the big screen in their order; undefined: the photo was removed. */
  readonly photos: (Photo | undefined)[] = [];
  readonly #listeners = new Set<() => void>();

  readonly #nowMs: () => number;

  /** @param nowMs the master's clock */
  constructor(party: Partial<FakeParty> = {}, nowMs: () => number = () => 1_000_000) {
    this.#nowMs = nowMs;
    this.party = { room: EMPTY_ROOM, link: 'connected', lagMs: 24, ...party };
  }

  get facts(): PhoneFacts {
    const { room, round, feedback, live, link, lagMs, masterUrl } = this.party;
    const me = room.players.find(({ key }) => key === KEY);
    return {
      view: { room, hostId: 'host', lags: {}, ...(round && { round }) },
      me,
      spectator: room.spectators.find(({ key }) => key === KEY),
      live,
      feedback,
      link,
      lagMs,
      masterUrl,
      nowMs: this.#nowMs,
    };
  }

  /** Changes the party, and notifies the page. */
  set(change: Partial<FakeParty>): void {
    this.party = { ...this.party, ...change };
    for (const listener of this.#listeners) listener();
  }

  /** Something happens in the room. */
  happens(event: RoomEvent): void {
    this.set({ room: nextRoom(this.party.room, event, this.#nowMs()) });
  }

  onChange(fn: () => void): () => void {
    this.#listeners.add(fn);
    return () => this.#listeners.delete(fn);
  }

  ask(action: PhoneAction): Promise<{ readonly code?: string }> {
    this.asked.push(action);
    try {
      if (action.type === 'offer') return Promise.resolve({ code: '7KRM' });
      if (action.type === 'take') this.#take(action.code);
      else this.happens(eventOf(action));
      return Promise.resolve({});
    } catch (error) {
      return Promise.reject(error as Error);
    }
  }

  #take(code: string): void {
    const away = this.party.room.players.find(({ awaySinceMs }) => awaySinceMs !== undefined);
    if (code !== '7KRM' || away?.key === undefined)
      throw new Error('No seat is offered with this code.');
    this.happens({ type: 'hand-over', key: away.key, to: KEY });
  }

  steer(x: number, y: number): void {
    this.sent.push({ x, y });
  }

  press(isDown: boolean): void {
    this.sent.push(isDown);
  }

  cheer(kind: CheerKind): void {
    this.cheers.push(kind);
  }

  answer(answer: Answer): void {
    this.answers.push(answer);
  }

  showPhoto(photo: Photo | undefined): void {
    this.photos.push(photo);
  }

  close(): void {
    this.#listeners.clear();
  }
}

function eventOf(action: Exclude<PhoneAction, { type: 'offer' | 'take' }>): RoomEvent {
  const by: Asker = { key: KEY };
  switch (action.type) {
    case 'join':
    case 'watch':
    case 'leave':
    case 'away':
    case 'back':
    case 'ready':
      return { ...action, key: KEY };
    case 'proceed':
    case 'kick':
    case 'lead':
    case 'dismiss':
    case 'lock':
    case 'hide-code':
    case 'set-teams':
    case 'set-pace':
    case 'set-games':
    case 'fill':
      return { ...action, by };
  }
}

/** A room in which this phone has a seat, with others. */
export function roomWith(seat: number, others: readonly string[] = ['Theo', 'Ines']): Room {
  const names = [...others];
  names.splice(Math.min(seat, names.length), 0, 'Mara');
  let room = EMPTY_ROOM;
  names.forEach((name, at) => {
    room = nextRoom(room, { type: 'join', key: name === 'Mara' ? KEY : `key-${at}`, name }, 0);
  });
  return {
    ...room,
    players: room.players.map((player) => (player.key === KEY ? { ...player, seat } : player)),
    ...(room.leader !== undefined && seat === 0 ? { leader: 0 } : { leader: room.leader ?? 0 }),
  };
}

/** Feedback of a player in the middle of a round. */
export const FEEDBACK: Feedback = {
  place: 2,
  of: 6,
  headline: 'Lap 2 of 3',
  sentence: 'The boost fills up.',
  progress: 0.55,
  gauge: 0.58,
  isReady: false,
  isOut: false,
  hitAt: 0,
};
