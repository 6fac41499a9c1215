import type { HiddenPhotos } from './photos/photo.ts';
import type { Room, Seat } from '../sim/index.ts';

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
