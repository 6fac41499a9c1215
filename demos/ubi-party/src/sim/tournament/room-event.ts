import type { Places, Seat } from '../game.ts';
import type { Pace } from './pace.ts';

/** Origin of a request: the big screen, or the client of a phone by its key. */
export type Asker = 'host' | { readonly key: string };

/** An event that changes a room. */
export type RoomEvent =
  | { readonly type: 'join'; readonly key: string; readonly name: string }
  | { readonly type: 'watch'; readonly key: string; readonly name: string }
  /** Deliberate: gives the seat back at once, or watches no longer. */
  | { readonly type: 'leave'; readonly key: string }
  /** Its connection was lost, or it is there again. */
  | { readonly type: 'away' | 'back'; readonly key: string }
  /** Another phone takes over the seat, with all that belongs to it. */
  | { readonly type: 'hand-over'; readonly key: string; readonly to: string }
  | { readonly type: 'ready'; readonly key: string; readonly isReady: boolean }
  | { readonly type: 'kick' | 'lead'; readonly by: Asker; readonly seat: Seat }
  /** Removes somebody who watches. */
  | { readonly type: 'dismiss'; readonly by: Asker; readonly key: string }
  | { readonly type: 'lock' | 'hide-code'; readonly by: Asker; readonly on: boolean }
  | { readonly type: 'set-teams'; readonly by: Asker; readonly teams: number }
  | { readonly type: 'set-games'; readonly by: Asker; readonly games: readonly string[] }
  /** Between rounds. */
  | { readonly type: 'set-pace'; readonly by: Asker; readonly pace: Pace }
  | {
      readonly type: 'set-setting';
      readonly by: Asker;
      readonly game: string;
      readonly setting: string;
      readonly value: number;
    }
  /** Bots on free seats, until so many play. */
  | { readonly type: 'fill'; readonly by: Asker; readonly players: number }
  /** On to what comes next: the first round, the end of an explanation or of a podium, a new tournament. */
  | { readonly type: 'proceed'; readonly by: Asker }
  | { readonly type: 'round-over'; readonly places: Places }
  | { readonly type: 'time' };

/** Why an event changed nothing, a sentence for the one who asked. */
export class RoomRefusal extends Error {
  override readonly name = 'RoomRefusal';
}
