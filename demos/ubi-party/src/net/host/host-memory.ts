import { EMPTY_ROOM, type Room } from '../../sim/index.ts';
import type { RoundState } from '../../modules/index.ts';
import type { RoundView } from '../room-view.ts';

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
