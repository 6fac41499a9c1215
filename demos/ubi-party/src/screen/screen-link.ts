import type { RoundState } from '../modules/index.ts';
import type { Photo, RoomView } from '../net/index.ts';
import type { Cheer, GameId, RoomEvent, Seat } from '../sim/index.ts';

/** State and actions of the big screen; implemented by a `PartyHost`. */
export interface ScreenLink {
  /** Undefined until the party is known. */
  readonly view: RoomView | undefined;
  /** The clock of the master, milliseconds since the Unix epoch. */
  nowMs(): number;
  /** Calls after each change of the view. @returns ends it */
  onView(fn: (view: RoomView) => void): () => void;
  /** Calls for each state of the round, 60 times a second. @returns ends it */
  onState(fn: (game: GameId, state: RoundState) => void): () => void;
  /** Calls for each cheer of a player or spectator. @returns ends it */
  onCheer(fn: (cheer: Cheer) => void): () => void;
  /** Number of cheers dropped by the rate limit and not shown. */
  readonly droppedCheers: number;
  /** @returns why nothing changed, a sentence; undefined when it did */
  apply(event: RoomEvent): string | undefined;
  /** A code with which another phone takes the seat over; undefined for a bot. */
  offerSeat(seat: Seat): string | undefined;
  setSetting(game: GameId, setting: string, value: number): void;
  /** Calls when photos come and go, by client id. @returns ends it */
  onPhotos(fn: (photos: ReadonlyMap<string, Photo>) => void): () => void;
  /** Takes a photo off the screen for everybody. */
  takeDownPhoto(seat: Seat): void;
  /** Takes all photos off, and shows none until it is called with false. */
  hidePhotos(areHidden: boolean): void;
}

/** Join instructions. */
export interface Invitation {
  /** Without `https://`, as people type it. */
  readonly address: string;
  /** The code to type at that address; undefined when none is asked for. */
  readonly code?: string;
  /** In the QR code. */
  readonly scanned: string;
}
