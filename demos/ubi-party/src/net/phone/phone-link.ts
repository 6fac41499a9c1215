import type { Answer, CheerKind, Feedback, Player, Spectator } from '../../sim/index.ts';
import type { LiveRound } from '../live-round.ts';
import type { PhoneAction, Photo, RoomView } from '../protocol.ts';

/** Current state of the party, as known to a phone. */
export interface PhoneFacts {
  /** Undefined until the room is known. */
  readonly view: RoomView | undefined;
  /** The player of this phone; undefined before it has joined, and after it was removed. */
  readonly me: Player | undefined;
  /** This phone, while it watches without a seat. */
  readonly spectator: Spectator | undefined;
  /** The running round; undefined while there is none, and for who plays it. */
  readonly live: LiveRound | undefined;
  /** Undefined while no round is played by this player. */
  readonly feedback: Feedback | undefined;
  readonly link: 'connecting' | 'connected' | 'lost';
  /** Base URL of the master that the phone is at, which may not be the one that its page was loaded from. */
  readonly masterUrl?: string | undefined;
  /** Whether the phone could go on at another master; so its page must not need more of the first one. */
  readonly isInCluster?: boolean;
  /** Round trip to the master, milliseconds. */
  readonly lagMs: number | undefined;
  /** The clock of the master, milliseconds since the Unix epoch. */
  nowMs(): number;
}

/** The phone of one player: what it knows, and what it can do. */
export interface PhoneLink {
  readonly facts: PhoneFacts;
  /** Calls after each change of the facts. @returns ends it */
  onChange(fn: () => void): () => void;
  /**
   * Asks the host. @returns the code of `offer`
   * @throws Error whose message is a sentence for the player
   */
  ask(action: PhoneAction): Promise<{ readonly code?: string }>;
  /** Sets the position of stick, wheel or tilt, each axis from -1 to 1. */
  steer(x: number, y: number): void;
  /** The button goes down or up. */
  press(isDown: boolean): void;
  /** A reaction for the big screen; too many are dropped. */
  cheer(kind: CheerKind): void;
  /** Publishes what the phone found. @param answer with its time in milliseconds since the Unix epoch, master's clock */
  answer(answer: Answer): void;
  /** The photo that the player shows on the big screen now. @param photo undefined: none any more */
  showPhoto(photo: Photo | undefined): void;
  close(): void;
}
