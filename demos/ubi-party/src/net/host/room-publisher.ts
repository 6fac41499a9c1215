import type { Clock, UbiiClient } from '@ubii/client-web';

import { readJson, ROOM_TOPIC, type RoomView } from '../protocol.ts';

/** Interval at which an unchanged room is published again: other screens see that it has a leading screen. */
const REPEAT_MS = 2000;
/** A retained value arrives right after the subscription. */
const STORED_WITHIN_MS = 500;

interface RoomPublisherOptions {
  readonly client: UbiiClient;
  readonly clock: Clock;
  /** Another screen began to lead later than this one. */
  handleSuperseded(byId: string): void;
}

/**
 * Publishes the room, and watches for rooms of other screens. Each screen states since when it leads: the one that began
 * last leads, in whatever order their records arrive.
 */
export class RoomPublisher {
  readonly #options: RoomPublisherOptions;
  #sinceMs: number | undefined;
  #before: RoomView | undefined;
  #publishedAtMs = -Infinity;
  #publishedText = '';

  constructor(options: RoomPublisherOptions) {
    this.#options = options;
  }

  /** When this screen began to lead, milliseconds since the Unix epoch, master's clock; undefined before. */
  get sinceMs(): number | undefined {
    return this.#sinceMs;
  }

  /** @returns the room that another screen has published, if any, and what ends the subscription */
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
  publish(view: RoomView): boolean {
    const text = JSON.stringify(view);
    const nowMs = this.#options.client.masterTime.nowMs();
    if (text === this.#publishedText && nowMs - this.#publishedAtMs < REPEAT_MS) return false;
    this.#publishedText = text;
    this.#publishedAtMs = nowMs;
    this.#options.client.publish(ROOM_TOPIC, 'string', text);
    return true;
  }

  #handleRoomOfOthers(text: string): void {
    const { client, handleSuperseded } = this.#options;
    const view = readJson<RoomView>(text) as RoomView | undefined;
    if (typeof view?.hostId !== 'string' || text === this.#publishedText) return;
    if (this.#sinceMs === undefined) this.#before = view;
    else if (view.hostId !== client.id && isLater(view, this.#sinceMs, client.id))
      handleSuperseded(view.hostId);
    // Its older record replaced the room of this screen as the retained one: publish again
    else this.#publishedAtMs = -Infinity;
  }
}

/** 0 for a screen that does not state it. */
export function sinceMsOf(view: RoomView | undefined): number {
  return Number.isFinite(view?.sinceMs) ? view!.sinceMs! : 0;
}

function isLater(view: RoomView, sinceMs: number, id: string): boolean {
  const otherMs = sinceMsOf(view);
  return otherMs > sinceMs || (otherMs === sinceMs && view.hostId > id);
}
