import { TouchEventType, type TouchEventList, type Vector3 } from '@ubii/proto';
import { SMART_DEVICE } from '../../devices/smart-device/components.ts';
import { HYSTERESIS } from './gatherer-topics.ts';

/** The data of a client that the page needs. */
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
  /** True for the finger that the session uses. */
  readonly isFirst: boolean;
}

/** Two phones with near touches. */
export interface NearPair {
  readonly key: string;
  readonly from: GatheredTouch;
  readonly to: GatheredTouch;
}

interface Finger {
  x: number;
  y: number;
}

/** Phones, their fingers and motion, and near touches. No network access. */
export class Gathering {
  #clients = new Map<string, PhoneClient>();
  readonly #fingers = new Map<string, Map<string, Finger>>();
  readonly #motion = new Map<string, number>();
  readonly #near = new Set<string>();

  /** Replaces the list of clients, and removes the data of clients that have left. */
  setClients(clients: Iterable<PhoneClient>): void {
    const before = this.#clients;
    this.#clients = new Map();
    for (const client of clients) {
      if (client.deviceNames.includes(SMART_DEVICE)) this.#clients.set(client.id, client);
    }
    // Only of clients that left: a touch may arrive before its client is in the list.
    for (const id of before.keys()) {
      if (this.#clients.has(id)) continue;
      this.#fingers.delete(id);
      this.#motion.delete(id);
      this.#near.delete(id);
    }
  }

  /** Applies the touch events of a client. */
  touch(clientId: string, { elements }: TouchEventList): void {
    const fingers = this.#fingers.get(clientId) ?? new Map<string, Finger>();
    this.#fingers.set(clientId, fingers);
    for (const { type, id, position } of elements) {
      if (type === TouchEventType.TOUCH_END) fingers.delete(id);
      else if (position) fingers.set(id, { x: clamp(position.x), y: clamp(position.y) });
    }
  }

  /** Stores an acceleration without gravity, m/s². */
  move(clientId: string, { x, y, z }: Vector3): void {
    this.#motion.set(clientId, Math.hypot(x, y, z));
  }

  /** Stores whether the session reports a near touch for a phone. */
  setNear(clientId: string, isNear: boolean): void {
    if (isNear) this.#near.add(clientId);
    else this.#near.delete(clientId);
  }

  /** Clears near touches, as when a session starts or ends. */
  forgetNear(): void {
    this.#near.clear();
  }

  isNear(clientId: string): boolean {
    return this.#clients.has(clientId) && this.#near.has(clientId);
  }

  /** Returns the length of the newest acceleration, m/s²; `undefined` before the first. */
  motionOf(clientId: string): number | undefined {
    return this.#motion.get(clientId);
  }

  /** Returns all phones, sorted by name. */
  phones(): PhoneClient[] {
    return [...this.#clients.values()].sort(
      (a, b) => a.name.localeCompare(b.name) || a.id.localeCompare(b.id),
    );
  }

  /** Returns the fingers of all phones. */
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
   * Returns the pairs of near touches. The session reports which phones are near another one; the pairs
   * follow from the positions.
   * @param distance largest distance of near touches, as a fraction of the pad
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
