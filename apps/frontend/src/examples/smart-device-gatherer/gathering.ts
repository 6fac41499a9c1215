import { TouchEventType, type TouchEventList, type Vector3 } from '@ubii/proto';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';
import { HYSTERESIS } from './gatherer-topics.ts';

/** What the page needs to know of a client. */
export interface PhoneClient {
  readonly id: string;
  readonly name: string;
  /** False while the client is silent. */
  readonly active: boolean;
  readonly deviceNames: readonly string[];
}

/** A finger on a phone; both axes 0 to 1, origin top left. */
export interface GatheredTouch {
  readonly key: string;
  readonly clientId: string;
  readonly x: number;
  readonly y: number;
  /** The one the session goes by. */
  readonly isFirst: boolean;
}

/** Two phones that feel each other. */
export interface NearPair {
  readonly key: string;
  readonly from: GatheredTouch;
  readonly to: GatheredTouch;
}

interface Finger {
  x: number;
  y: number;
}

/** The phones that are here, their fingers, their motion, and who is near. Plain: it knows no network. */
export class Gathering {
  #clients = new Map<string, PhoneClient>();
  readonly #fingers = new Map<string, Map<string, Finger>>();
  readonly #motion = new Map<string, number>();
  readonly #near = new Set<string>();

  /** Replaces what is known of the clients; who has left leaves nothing behind. */
  setClients(clients: Iterable<PhoneClient>): void {
    const before = this.#clients;
    this.#clients = new Map();
    for (const client of clients) {
      if (client.deviceNames.includes(SMART_DEVICE)) this.#clients.set(client.id, client);
    }
    // Only of those that left: a touch may arrive before the client it belongs to.
    for (const id of before.keys()) {
      if (this.#clients.has(id)) continue;
      this.#fingers.delete(id);
      this.#motion.delete(id);
      this.#near.delete(id);
    }
  }

  /** Takes the fingers that came down, moved or left. */
  touch(clientId: string, { elements }: TouchEventList): void {
    const fingers = this.#fingers.get(clientId) ?? new Map<string, Finger>();
    this.#fingers.set(clientId, fingers);
    for (const { type, id, position } of elements) {
      if (type === TouchEventType.TOUCH_END) fingers.delete(id);
      else if (position) fingers.set(id, { x: clamp(position.x), y: clamp(position.y) });
    }
  }

  /** Takes an acceleration without gravity, m/s². */
  move(clientId: string, { x, y, z }: Vector3): void {
    this.#motion.set(clientId, Math.hypot(x, y, z));
  }

  /** Takes what the session says of a phone. */
  setNear(clientId: string, isNear: boolean): void {
    if (isNear) this.#near.add(clientId);
    else this.#near.delete(clientId);
  }

  /** A session that begins anew, or has ended, says nothing of what was. */
  forgetNear(): void {
    this.#near.clear();
  }

  isNear(clientId: string): boolean {
    return this.#clients.has(clientId) && this.#near.has(clientId);
  }

  /** Length of the newest acceleration, m/s²; `undefined` before the first. */
  motionOf(clientId: string): number | undefined {
    return this.#motion.get(clientId);
  }

  /** Everybody with a phone, by name. */
  phones(): PhoneClient[] {
    return [...this.#clients.values()].sort(
      (a, b) => a.name.localeCompare(b.name) || a.id.localeCompare(b.id),
    );
  }

  /** Every finger of those who are here. */
  touches(): GatheredTouch[] {
    return [...this.#clients.keys()].flatMap((clientId) =>
      [...(this.#fingers.get(clientId) ?? [])].map(([id, { x, y }], index) => ({
        key: `${clientId} ${id}`,
        clientId,
        x,
        y,
        isFirst: index === 0,
      })),
    );
  }

  /**
   * Who feels whom. The session says who is near somebody, the places say whom.
   * @param distance so near is near, in parts of the pad
   */
  pairs(distance: number): NearPair[] {
    const near = this.touches().filter((one) => one.isFirst && this.#near.has(one.clientId));
    return near.flatMap((from, index) =>
      near
        .slice(index + 1)
        .filter((to) => Math.hypot(from.x - to.x, from.y - to.y) <= distance + HYSTERESIS)
        .map((to) => ({ key: `${from.clientId} ${to.clientId}`, from, to })),
    );
  }
}

function clamp(value: number): number {
  return Math.min(1, Math.max(0, value));
}
