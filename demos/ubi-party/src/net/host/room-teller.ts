import type { Clock, UbiiClient } from '@ubii/client-web';
import { readJson } from '../read-json.ts';
import type { RoomView } from '../room-view.ts';
import { ROOM_TOPIC } from '../topics.ts';

/** The room is told again so often: who joins late, and another screen, see that it is led. */
const TELL_AGAIN_MS = 2000;
/** A value that the master has comes right after the subscription. */
const STORED_WITHIN_MS = 500;

export interface RoomTellerOptions {
  readonly client: UbiiClient;
  readonly clock: Clock;
  /** Another screen began to lead later than this one. */
  handleSuperseded(byId: string): void;
}

/**
 * Tells everybody the room, and hears when another screen does. Each screen says since when it leads: the one that began
 * last leads, in whatever order their records arrive.
 */
export class RoomTeller {
  readonly #options: RoomTellerOptions;
  #sinceMs: number | undefined;
  #before: RoomView | undefined;
  #toldAtMs = -Infinity;
  #toldText = '';

  constructor(options: RoomTellerOptions) {
    this.#options = options;
  }

  /** When this screen began to lead, milliseconds since the Unix epoch, master's clock; undefined before. */
  get sinceMs(): number | undefined {
    return this.#sinceMs;
  }

  /** @returns the room that another screen has told, if there is one, and what ends hearing others */
  open(): { readonly before: Promise<RoomView | undefined>; close(): void } {
    const { client, clock } = this.#options;
    const rooms = client.subscribe(ROOM_TOPIC, { format: 'string' });
    const stored = new Promise<void>((resolve) => {
      void rooms.ready.then(() => clock.after(STORED_WITHIN_MS, resolve)).catch(() => undefined);
      rooms.onRecord(({ value }) => {
        this.#handleRoomOfOthers(value);
        resolve();
      });
    });
    const before = rooms.ready.then(() => stored).then(() => this.#before);
    return { before, close: () => void rooms.close() };
  }

  /** Begins to lead: later than the screen before, also if the clock of the master was set back. */
  lead(): void {
    const nowMs = this.#options.client.masterTime.nowMs();
    this.#sinceMs = Math.max(nowMs, sinceMsOf(this.#before) + 1);
  }

  /** Publishes the room when it has changed, and unchanged at an interval. @returns whether it was published */
  tell(view: RoomView): boolean {
    const text = JSON.stringify(view);
    const nowMs = this.#options.client.masterTime.nowMs();
    if (text === this.#toldText && nowMs - this.#toldAtMs < TELL_AGAIN_MS) return false;
    this.#toldText = text;
    this.#toldAtMs = nowMs;
    this.#options.client.publish(ROOM_TOPIC, 'string', text);
    return true;
  }

  #handleRoomOfOthers(text: string): void {
    const { client, handleSuperseded } = this.#options;
    const view = readJson<RoomView>(text) as RoomView | undefined;
    if (typeof view?.hostId !== 'string' || text === this.#toldText) return;
    if (this.#sinceMs === undefined) this.#before = view;
    else if (view.hostId !== client.id && isLater(view, this.#sinceMs, client.id))
      handleSuperseded(view.hostId);
    // What it sent before it heard of this screen is the stored room now
    else this.#toldAtMs = -Infinity;
  }
}

/** Of a screen that says nothing: 0. */
export function sinceMsOf(view: RoomView | undefined): number {
  return Number.isFinite(view?.sinceMs) ? view!.sinceMs! : 0;
}

function isLater(view: RoomView, sinceMs: number, id: string): boolean {
  const otherMs = sinceMsOf(view);
  return otherMs > sinceMs || (otherMs === sinceMs && view.hostId > id);
}
