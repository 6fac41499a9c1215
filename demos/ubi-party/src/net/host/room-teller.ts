import type { UbiiClient } from '@ubii/client-web';
import { readJson } from '../read-json.ts';
import type { RoomView } from '../room-view.ts';
import { ROOM_TOPIC } from '../topics.ts';

/** The room is told again so often: who joins late, and another screen, see that it is led. */
const TELL_AGAIN_MS = 2000;

export interface RoomTellerOptions {
  readonly client: UbiiClient;
  readonly nowMs: () => number;
  /** Another screen tells a room: it leads from now on. */
  handleSuperseded(byId: string): void;
}

/** Tells everybody the room, and hears when another screen does. */
export class RoomTeller {
  readonly #options: RoomTellerOptions;
  #toldAtMs = -Infinity;
  #toldText = '';

  constructor(options: RoomTellerOptions) {
    this.#options = options;
  }

  /** @returns when others are heard, and what ends it */
  open(): { readonly ready: Promise<void>; close(): void } {
    const rooms = this.#options.client.subscribe(ROOM_TOPIC, { format: 'string' });
    rooms.onRecord(({ value }) => this.#handleRoomOfOthers(value));
    return { ready: rooms.ready, close: () => void rooms.close() };
  }

  /** Publishes the room when it has changed, and unchanged at an interval. @returns whether it was published */
  tell(view: RoomView): boolean {
    const text = JSON.stringify(view);
    const nowMs = this.#options.nowMs();
    if (text === this.#toldText && nowMs - this.#toldAtMs < TELL_AGAIN_MS) return false;
    this.#toldText = text;
    this.#toldAtMs = nowMs;
    this.#options.client.publish(ROOM_TOPIC, 'string', text);
    return true;
  }

  /** Another big screen says that it leads: the last one who began does. */
  #handleRoomOfOthers(text: string): void {
    const hostId = readJson<RoomView>(text)?.hostId;
    const { client, handleSuperseded } = this.#options;
    if (typeof hostId !== 'string' || hostId === client.id || text === this.#toldText) return;
    // The stored record of an earlier screen arrives once, before this one has published anything
    if (this.#toldText !== '') handleSuperseded(hostId);
  }
}
