import type { DataFormat } from '@ubii/proto';

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
/** A setting of a game that anybody may change while it runs, a number; 1 is as it is meant. */
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
