import type { DataFormat } from '@ubii/proto';

import type { Pace, Seat, Room } from '../sim/index.ts';

/**
 * Parses a record that holds a JSON object; undefined for other texts. Any client that may publish on the topic can publish any text:
 * the caller checks the members that it uses.
 */
export function readJson<T extends object>(text: string): Partial<T> | undefined {
  try {
    const value: unknown = JSON.parse(text);
    return typeof value === 'object' && value !== null ? (value as Partial<T>) : undefined;
  } catch {
    return undefined;
  }
}

/** Retained: the room as everybody sees it, JSON of a `RoomView`. */
export const ROOM_TOPIC = '/party/room';
/** Retained: who sits where in the round, JSON of `RoundSeats`; an input of the modules. */
export const SEATS_TOPIC = '/party/seats';
/** Retained: the round, JSON of a `RoundPlan`; an input of the modules. */
export const ROUND_TOPIC = '/party/round';
/** Retained: the running round in words, JSON of a `LiveRound`; published while the room has spectators. */
export const LIVE_TOPIC = '/party/live';
/** All that a player may read beside the own topics. */
export const PLAYER_READS = [ROOM_TOPIC, LIVE_TOPIC] as const;
/** The state of the running round, JSON, 60 times a second. */
export const stateTopic = (game: string): string => `/party/${game}/state`;
/** A setting of a game that any client may change while it runs, a number; 1 is the default. */
export const settingTopic = (game: string, setting: string): string => `/party/${game}/${setting}`;

/** Components of every phone, also of one that only watches. `reply` is received, the others are published. */
export const WATCH_COMPONENTS = {
  /** Once a second while the page is seen: the round trip to the master, milliseconds. */
  here: { format: 'double', ioType: 'publisher' },
  /** A request of the player to the host, JSON of a `PhoneRequest`. */
  request: { format: 'string', ioType: 'publisher' },
  /** The host's reply, JSON of a `HostReply`. */
  reply: { format: 'string', ioType: 'subscriber' },
  /** A reaction for the big screen, a `CheerKind`; gone a second later. */
  cheer: { format: 'string', ioType: 'publisher' },
} as const satisfies Components;

/** Components of a phone that has a seat, with their data formats. `feedback` is received, the others are published. */
export const SEAT_COMPONENTS = {
  /** Stick, wheel or tilt, each from -1 to 1: right and away from the player are positive. */
  stick: { format: 'vector2', ioType: 'publisher' },
  /** Whether the button is down. */
  button: { format: 'bool', ioType: 'publisher' },
  /** When it went down last, milliseconds since the Unix epoch, master's clock. */
  pressed: { format: 'double', ioType: 'publisher' },
  /**
   * The object detected by the phone: its name as `id`, its position in the picture (0 to 1 from the top left), and in
   * `userDataJson` `score` (0 to 1) and `atMs`, the time of the player's action, like `pressed`. An empty `id`:
   * detection is still running.
   */
  answer: { format: 'object2D', ioType: 'publisher' },
  /** A photo that the player shows on the big screen, a JPEG file; its time is that of its answer. */
  photo: { format: 'image2D', ioType: 'publisher' },
  /** Feedback for the player, JSON of a `Feedback`. */
  feedback: { format: 'string', ioType: 'subscriber' },
} as const satisfies Components;
type Components = Readonly<
  Record<string, { format: DataFormat; ioType: 'publisher' | 'subscriber' }>
>;

export const PHONE_COMPONENTS = { ...WATCH_COMPONENTS, ...SEAT_COMPONENTS };
export type PhoneComponent = keyof typeof PHONE_COMPONENTS;

/** The name of the device that a phone registers, and the tag of its components. */
export const PHONE_DEVICE = 'party';
/** The device of a phone with a seat, beside the other one. */
export const SEAT_DEVICE = 'party-seat';

export const phoneTopic = (clientId: string, component: PhoneComponent): string =>
  `/${clientId}/${PHONE_DEVICE}/${component}`;

/** The client whose topic it is, if it is one of a phone. */
export function phoneOf(topic: string, component: PhoneComponent): string | undefined {
  const match = /^\/([^/]+)\/party\/([^/]+)$/.exec(topic);
  return match?.[2] === component ? match[1] : undefined;
}

/** A photo as it is shown: a JPEG file without Exif. */
export interface Photo {
  readonly jpeg: Uint8Array<ArrayBuffer>;
  /** Pixels. */
  readonly width: number;
  readonly height: number;
  /** When the shutter was pressed, whole milliseconds since the Unix epoch, master's clock. */
  readonly atMs: number;
}

/** Longest side of a photo, pixels. */
export const MAX_PHOTO_SIDE = 480;
export const MAX_PHOTO_BYTES = 60_000;

/** Photos that the host has removed from the big screen, for everybody. */
export interface HiddenPhotos {
  /** All photos, also those to come. */
  readonly all: boolean;
  /** `photoId` of single photos. */
  readonly ids: readonly string[];
}

export const photoId = (clientId: string, { atMs }: Pick<Photo, 'atMs'>): string =>
  `${clientId}@${atMs}`;

export function isHidden(hidden: HiddenPhotos | undefined, id: string): boolean {
  return hidden !== undefined && (hidden.all || hidden.ids.includes(id));
}

/** A request of a phone to the host. Requests that lead the game are for the leader's phone only. */
export type PhoneAction =
  | { readonly type: 'join' | 'watch'; readonly name: string }
  | { readonly type: 'leave' | 'away' | 'back' }
  | { readonly type: 'ready'; readonly isReady: boolean }
  /** A code with which another phone takes over the seat. */
  | { readonly type: 'offer' }
  | { readonly type: 'take'; readonly code: string }
  | { readonly type: 'proceed' }
  | { readonly type: 'kick' | 'lead'; readonly seat: Seat }
  | { readonly type: 'dismiss'; readonly key: string }
  | { readonly type: 'lock' | 'hide-code'; readonly on: boolean }
  | { readonly type: 'set-teams'; readonly teams: number }
  | { readonly type: 'set-pace'; readonly pace: Pace }
  | { readonly type: 'set-games'; readonly games: readonly string[] }
  | { readonly type: 'fill'; readonly players: number };

/** A request; `number` grows with each, and the reply repeats it. */
export interface PhoneRequest {
  readonly number: number;
  readonly wish: PhoneAction;
}

/** The answer of the host. */
export interface HostReply {
  readonly number: number;
  /** Why nothing changed, one sentence. */
  readonly refusal?: string;
  /** Of `offer`. */
  readonly code?: string;
}

/** The round that is played or about to begin. */
export interface RoundView {
  /** Of each round its own. */
  readonly id: string;
  readonly game: string;
  readonly seed: number;
  /** Milliseconds since the Unix epoch, master's clock: everybody starts at the same time. */
  readonly startsAtMs: number;
  readonly seats: readonly Seat[];
  /** Times to answer are so many times as long. @default 1 */
  readonly pace?: number;
  /** The session it runs in, which can be opened in the graph editor. */
  readonly sessionId?: string;
}

/** The public state of a room. */
export interface RoomView {
  readonly room: Room;
  /** The client of the big screen. */
  readonly hostId: string;
  /** When it began to lead, milliseconds since the Unix epoch, master's clock: of two, the later one leads. */
  readonly sinceMs?: number;
  readonly round?: RoundView;
  /** Photos that the host has removed from the big screen. */
  readonly hiddenPhotos?: HiddenPhotos;
  /** Round trips of the players, milliseconds, by seat. */
  readonly lags: Readonly<Record<Seat, number>>;
}
