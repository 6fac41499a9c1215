import type { Clock, UbiiClient } from '@ubii/client-web';
import type { RoundState } from '../../modules/index.ts';
import type { Cheer, GameId } from '../../sim/index.ts';
import type { Photo } from '../photos/photo.ts';
import type { RoomView } from '../room-view.ts';
import type { HostStorage } from './host-memory.ts';

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
