import type { Clock, UbiiClient } from '@ubii/client-web';

import type { RoundState } from '../../modules/index.ts';
import { EMPTY_ROOM, type Room, type Cheer, type GameId } from '../../sim/index.ts';
import type { RoundView, Photo, RoomView } from '../protocol.ts';

/** State from which the big screen continues after a reload or after a restart of the master. */
export interface HostMemory {
  readonly room: Room;
  readonly round?: RoundView;
  /** When the screen that stored it began to lead, as in `RoomView`. */
  readonly sinceMs?: number;
  /** The host hides all photos. */
  readonly arePhotosHidden?: boolean;
  /** The newest state of the round that is played. */
  readonly state?: RoundState;
}

/** Storage of the host's state: the browser's storage, or none. */
export interface HostStorage {
  load(): HostMemory | undefined;
  save(memory: HostMemory): void;
}

export const EMPTY_MEMORY: HostMemory = { room: EMPTY_ROOM };

/** Callbacks for the big screen. */
export interface PartyHostListener {
  /** The room, the round or the lags changed. */
  handleView?(view: RoomView): void;
  /** The newest state of the round, 60 times a second. */
  handleState?(game: GameId, state: RoundState): void;
  /** The photos that are shown, by client id. */
  handlePhotos?(photos: ReadonlyMap<string, Photo>): void;
  /** A player or a spectator cheers. */
  handleCheer?(cheer: Cheer): void;
  /** Another screen has taken over: this one leads no longer. */
  handleSuperseded?(byId: string): void;
  /** Something failed that the host should know, one sentence. */
  handleTrouble?(sentence: string): void;
}

export interface PartyHostOptions {
  readonly client: UbiiClient;
  readonly clock: Clock;
  readonly storage: HostStorage;
  /** A random integer from 0 to 255. */
  readonly drawByte: () => number;
  readonly listener: PartyHostListener;
}
