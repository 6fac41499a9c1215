import { clientOfPointerTopic, POINTER_DEVICE } from '../../devices/pointer-topic.ts';

/** The data of a client that the page needs to draw its pointer. */
export interface PointerClient {
  readonly id: string;
  readonly name: string;
  /** False while the client is silent. */
  readonly active: boolean;
  readonly deviceNames: readonly string[];
}

/** A client on this example and the position of its pointer; both axes 0 to 1, origin top left. */
export interface Pointer {
  readonly clientId: string;
  readonly name: string;
  readonly active: boolean;
  readonly position: { readonly x: number; readonly y: number } | undefined;
}

/**
 * The clients on the example and their pointers. A pointer stays while its client has the example's
 * device, also when it does not move. Records of clients that have left are ignored.
 */
export class Pointers {
  #positions = new Map<string, { x: number; y: number }>();
  #clients = new Map<string, PointerClient>();

  /** Replaces the list of clients. */
  setClients(clients: Iterable<PointerClient>): void {
    const before = this.#clients;
    this.#clients = new Map();
    for (const client of clients) {
      if (client.deviceNames.includes(POINTER_DEVICE)) this.#clients.set(client.id, client);
    }
    // Only of clients that left: a position may arrive before its client is in the list.
    for (const clientId of before.keys()) {
      if (!this.#clients.has(clientId)) this.#positions.delete(clientId);
    }
  }

  /** Stores a record of a pointer topic. Returns its client; `undefined` for another topic. */
  move(topic: string, value: { x: number; y: number }): string | undefined {
    const clientId = clientOfPointerTopic(topic);
    if (clientId === undefined) return undefined;
    this.#positions.set(clientId, { x: clamp(value.x), y: clamp(value.y) });
    return clientId;
  }

  /** Returns the position of the client's pointer; `undefined` before its first record. */
  position(clientId: string): { readonly x: number; readonly y: number } | undefined {
    return this.#positions.get(clientId);
  }

  /** Returns all clients on the example, sorted by name. */
  list(): Pointer[] {
    return [...this.#clients.values()]
      .map(({ id, name, active }) => ({
        clientId: id,
        name,
        active,
        position: this.#positions.get(id),
      }))
      .sort((a, b) => a.name.localeCompare(b.name) || a.clientId.localeCompare(b.clientId));
  }
}

function clamp(value: number): number {
  return Math.min(1, Math.max(0, value));
}
